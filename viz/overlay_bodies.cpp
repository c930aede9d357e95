#include "viz/overlay_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace packstone::viz {

namespace {

constexpr double thinnest_link = 0.08;  // of the thickest, so that weak contacts are seen
constexpr double shaft_radius = 0.045;  // of an arrow's length
constexpr double head_radius = 2.5;     // of the shaft's
constexpr double head_length = 0.35;    // of the arrow's
constexpr double path_radius = 0.22;    // of the mean particle, at the particle
constexpr double path_end = 0.25;       // of that, at the oldest place
constexpr double path_fading = 0.75;    // towards the ground, at the oldest place
constexpr double shortest = 1e-9;       // in unit space: an arrow below has no direction to see

double mean_radius(const Snapshot& snapshot) {
  const double sum = std::accumulate(snapshot.radius.begin(), snapshot.radius.end(), 0.0);
  return sum / static_cast<double>(std::max<std::size_t>(1, snapshot.size()));
}

Colour towards(Colour ground, Colour c, double share) {
  const auto mixed = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {mixed(c.r, ground.r), mixed(c.g, ground.g), mixed(c.b, ground.b)};
}

/// What the full size stands for.
double scale_of(const SegmentSet& set, double quantile, double asked_for) {
  const double value = asked_for > 0 ? asked_for : set.quantile(quantile);
  return value > 0 ? value : 1;
}

}  // namespace

class OverlayBodies::Builder {
 public:
  Builder(OverlayBodies& bodies, const Snapshot& snapshot, const UnitSpace& space, const PictureOptions& options)
      : bodies_(bodies), domain_(snapshot.domain), space_(space), options_(options), mean_(mean_radius(snapshot)) {}

  void add_links(const SegmentSet& links) {
    const double thickest = scale_of(links, link_quantile, options_.look.thickest_force);
    const double radius = options_.look.link_width * mean_;
    for (const Segment& link : links.segments) {
      const double share = std::min(1.0, link.value / thickest), r = radius * std::max(thinnest_link, share);
      const Colour colour = sequential_colour(share, ColourMap::plasma);
      add_tube(link.from, link.way, r, r, colour);
      if (options_.shown != Shown::hidden) continue;  // else the ends are inside the particles
      add_ball(link.from, r, colour);
      add_ball(domain_.wrapped(link.from + link.way), r, colour);
    }
  }

  void add_arrows(const SegmentSet& arrows) {
    const double longest = scale_of(arrows, arrow_quantile, options_.look.longest_arrow);
    for (const Segment& arrow : arrows.segments) {
      const double share = arrow.value / longest, length = options_.look.arrow_length * mean_ * share;
      if (is_cut_away(options_.cut, arrow.from) || length * space_.scale < shortest) continue;
      const Vec3 way = length / arrow.value * arrow.way, neck = arrow.from + (1 - head_length) * way;
      const double shaft = shaft_radius * length;
      const Colour colour = sequential_colour(share, ColourMap::plasma);
      add(arrow.from, neck, shaft, shaft, colour);
      add(neck, arrow.from + way, head_radius * shaft, 0, colour);
    }
  }

  void add_path(const Path& path, Colour colour) {
    const double steps = std::max(1.0, static_cast<double>(path.points.size()) - 1);
    for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
      const double age = 1 - static_cast<double>(k + 1) / steps, older = 1 - static_cast<double>(k) / steps;
      const auto radius = [&](double of_age) { return path_radius * mean_ * (1 - of_age * (1 - path_end)); };
      const Colour faded = towards(themed(paper, options_.ground), colour, path_fading * age);
      add_tube(path.points[k], domain_.separation(path.points[k + 1], path.points[k]), radius(older), radius(age),
               faded);
      add_ball(path.points[k], radius(older), faded);
    }
  }

 private:
  void add_tube(const Vec3& from, const Vec3& way, double from_radius, double to_radius, Colour colour) {
    double done = 0;
    const double whole = way.norm();
    const auto radius = [&](double length) { return from_radius + (to_radius - from_radius) * length / whole; };
    for (const auto& [start, stop] : pieces_inside(domain_, from, way)) {
      const double length = (stop - start).norm();
      if (!is_cut_away(options_.cut, (start + stop) / 2)) {
        add(start, stop, radius(done), radius(done + length), colour);
      }
      done += length;
    }
  }

  Vec3 in_space(const Vec3& p) const { return (p - space_.centre) * space_.scale; }

  void add(const Vec3& from, const Vec3& to, double from_radius, double to_radius, Colour colour) {
    bodies_.frusta.push_back(
        {in_space(from), in_space(to), from_radius * space_.scale, to_radius * space_.scale, colour});
  }

  void add_ball(const Vec3& centre, double radius, Colour colour) {
    if (is_cut_away(options_.cut, centre)) return;
    bodies_.centres.push_back(in_space(centre));
    bodies_.radii.push_back(radius * space_.scale);
    bodies_.colours.push_back(colour);
  }

  OverlayBodies& bodies_;
  const Domain& domain_;
  const UnitSpace& space_;
  const PictureOptions& options_;
  double mean_;
};

OverlayBodies::OverlayBodies(const Overlay& overlay, const Snapshot& snapshot, const UnitSpace& space,
                             const Colouring& colouring, const PictureOptions& options) {
  Builder builder(*this, snapshot, space, options);
  builder.add_links(overlay.links);
  builder.add_arrows(overlay.arrows);
  if (!overlay.paths.empty()) {
    std::unordered_map<std::int64_t, Colour> colour_of;
    for (std::size_t row = 0; row < snapshot.size(); ++row) colour_of.emplace(snapshot.id[row], colouring.colours[row]);
    for (const Path& path : overlay.paths) {
      const auto colour = colour_of.find(path.id);
      builder.add_path(path, colour == colour_of.end() ? no_value : colour->second);
    }
  }
  const auto add_key = [&](const SegmentSet& set, double quantile, double asked_for) {
    if (set.title.empty()) return;
    keys.push_back({set.title, {}, ValueRange{0, scale_of(set, quantile, asked_for)}, ColourMap::plasma});
  };
  add_key(overlay.links, link_quantile, options.look.thickest_force);
  add_key(overlay.arrows, arrow_quantile, options.look.longest_arrow);
}

}  // namespace packstone::viz
