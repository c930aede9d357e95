// Solid fraction by distance from the axis and from the side walls.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/blocks.hpp"
#include "analysis/layers.hpp"
#include "analysis/packing/fractions.hpp"
#include "analysis/packing/images.hpp"
#include "core/bed.hpp"

namespace packstone::analysis {

namespace {

const char* const profile_text =
    "exact parts of spheres (overlaps counted twice) over the shell's volume, between 10 % and 80 % of bed_height, or "
    "over the whole height where the domain is periodic along up";

/// Shells of equal width between a container's side walls and its middle, the outermost first.
struct Shells {
  double width = 0;                   ///< [m]
  std::vector<double> volume, solid;  ///< [m3]

  std::size_t size() const { return volume.size(); }
  double fraction(std::size_t k) const { return solid[k] / volume[k]; }
};

struct Span {
  double lower, upper;  // coordinates along up [m]
};

Span profile_heights(const Context& context) {
  const BedFrame& frame = context.frame;
  const double low = frame.periodic ? 0 : bulk_lower * context.bed.height;
  const double high = frame.periodic ? frame.extent : bulk_upper * context.bed.height;
  const auto [lower, upper] = std::minmax({frame.floor + frame.sign * low, frame.floor + frame.sign * high});
  return {lower, upper};
}

Shells shells_of(const Snapshot& snapshot, const Context& context, const Container& container) {
  const double wanted = context.options.wall_layer > 0 ? context.options.wall_layer : context.mean_radius;
  const double half_width = container.half_width();
  const double count = std::clamp(std::round(half_width / wanted), 1.0, static_cast<double>(most_layers));
  const auto shells = static_cast<std::size_t>(count);
  const auto [lower, upper] = profile_heights(context);

  // What is at least so far from the wall, for every shell's outer side, and the empty rest behind the innermost.
  std::vector<RegionShape> column;
  for (std::size_t k = 0; k < shells; ++k) {
    column.push_back(container.column(half_width * static_cast<double>(k) / count, lower, upper));
  }
  Shells result{.width = half_width / count, .volume = {}, .solid = {}};
  for (std::size_t k = 0; k < shells; ++k) {
    result.volume.push_back(region_volume(column[k]) - (k + 1 < shells ? region_volume(column[k + 1]) : 0));
  }
  const BoxRegion box = bounds(column.front());
  result.solid = bins_in_blocks(snapshot.size(), shells, [&](Eigen::VectorXd& sum, std::size_t i) {
    const double r = snapshot.radius[i];
    for_each_image(snapshot.domain, snapshot.position[i], r, box, [&](const Vec3& image) {
      const double distance = container.wall_distance(image);
      const double first = std::max(std::floor((distance - r) / result.width), 0.0);
      const double last = std::min(std::floor((distance + r) / result.width), count - 1);
      if (last < first) return;
      double inside = volume_in_region(column[static_cast<std::size_t>(first)], image, r);
      for (double k = first; k <= last; ++k) {
        const auto shell = static_cast<std::size_t>(k);
        const double further = shell + 1 < shells && k < last ? volume_in_region(column[shell + 1], image, r) : 0;
        sum[shell] += inside - further;
        inside = further;
      }
    });
  });
  return result;
}

std::string reason_against(const Snapshot& snapshot, const Context& context, const Container& container) {
  if (snapshot.size() == 0) return "no particles";
  if (!(context.mean_radius > 0)) return "all radii are 0";
  if (!container.unknown.empty()) return container.unknown;
  if (!context.frame.periodic && !(context.bed.height > 0)) return "all particles lie below the floor";
  return container.half_width() > 0 ? "" : "there are no side walls";
}

/// The largest upright cylinder in a container with walls on all sides; none where a side is periodic.
std::optional<Container> inscribed(Container container) {
  if (container.round) return container;
  for (int k = 0; k < 3; ++k) {
    if (k != container.axis && !container.walled[k]) return std::nullopt;
  }
  container.radius = container.half_width();
  container.round = true;
  return container;
}

}  // namespace

void add_wall_profiles(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                       const Container& container) {
  Table radial{.key = "radial_profile",
               .caption = std::string("Solid fraction by distance from the middle line of the cylinder or box "
                                      "(up to the nearest wall): ") +
                          profile_text,
               .columns = {{"inner", "m"}, {"outer", "m"}, {"fraction"}}};
  Table wall{.key = "wall_profile",
             .caption = std::string("Solid fraction by distance from the nearest side wall: ") + profile_text,
             .columns = {{"lower", "m"}, {"upper", "m"}, {"fraction"}}};
  const std::string reason = reason_against(snapshot, context, container);
  const auto round = inscribed(container);
  if (!reason.empty()) {
    radial.caption += "; not applicable: " + reason;
    wall.caption += "; not applicable: " + reason;
  } else {
    const Shells shells = shells_of(snapshot, context, container);
    for (std::size_t k = 0; k < shells.size(); ++k) {
      const double from = shells.width * static_cast<double>(k);
      wall.rows.push_back({from, from + shells.width, shells.fraction(k)});
    }
    if (round) {
      const Shells rings = container.round ? shells : shells_of(snapshot, context, *round);
      for (std::size_t k = rings.size(); k-- > 0;) {
        const double inner = rings.width * static_cast<double>(rings.size() - 1 - k);
        radial.rows.push_back({inner, inner + rings.width, rings.fraction(k)});
      }
    } else {
      radial.caption += "; not applicable: a side is periodic";
    }
  }
  result.tables.push_back(std::move(radial));
  result.tables.push_back(std::move(wall));
}

}  // namespace packstone::analysis
