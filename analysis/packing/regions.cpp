// Solid fraction of the regions that the user names.
#include <fmt/format.h>

#include "analysis/blocks.hpp"
#include "analysis/packing/fractions.hpp"
#include "analysis/packing/images.hpp"
#include "analysis/packing/lens.hpp"
#include "analysis/packing/region.hpp"

namespace packstone::analysis {

namespace {

struct Content {
  double solid;      // [m3]
  double particles;  // with any part inside
};

Content content_of(const RegionShape& region, const Snapshot& snapshot) {
  const BoxRegion box = bounds(region);
  const auto sums = bins_in_blocks(snapshot.size(), 2, [&](Eigen::VectorXd& sum, std::size_t i) {
    double volume = 0;
    for_each_image(snapshot.domain, snapshot.position[i], snapshot.radius[i], box,
                   [&](const Vec3& image) { volume += volume_in_region(region, image, snapshot.radius[i]); });
    sum[0] += volume;
    sum[1] += volume > 0 ? 1 : 0;
  });
  return {sums[0], sums[1]};
}

/// Sum of the lenses whose middle lies in the region [m3].
double counted_twice(const RegionShape& region, const Snapshot& snapshot, const Context& context) {
  const BoxRegion box = bounds(region);
  const auto& pairs = context.contacts.pairs;
  return bins_in_blocks(pairs.size(), 1, [&](Eigen::VectorXd& sum, std::size_t k) {
    const NearPair& pair = pairs[k];
    const double radius = snapshot.radius[pair.first];
    const Vec3 between = snapshot.domain.separation(snapshot.position[pair.first], snapshot.position[pair.second]);
    const double distance = between.norm();
    Vec3 middle = snapshot.position[pair.first];
    if (distance > 0) middle -= (radius - pair.overlap / 2) / distance * between;
    for_each_image(snapshot.domain, middle, 0, box, [&](const Vec3& image) {
      if (contains(region, image)) sum[0] += lens_volume(radius, snapshot.radius[pair.second], pair.overlap);
    });
  })[0];
}

std::string legend(const std::vector<NamedRegion>& regions) {
  if (regions.empty()) return "none named (--region)";
  std::string text;
  for (std::size_t k = 0; k < regions.size(); ++k)
    text += fmt::format("{}{} {}", k > 0 ? "; " : "", k, regions[k].text);
  return text;
}

}  // namespace

void add_regions(MeasureResult& result, const Snapshot& snapshot, const Context& context) {
  const auto& regions = context.options.regions;
  Table table{.key = "regions",
              .caption = "Regions (" + legend(regions) +
                         "), clipped to the domain where it is not periodic; solid: exact volumes of the spheres' "
                         "parts inside, periodic images too, so that cut spheres add no error; overlaps of spheres "
                         "count twice, by overlap_share of solid (lenses whose middle lies inside); particles: with "
                         "any part inside",
              .columns = {{"region", "", ColumnFormat::integer},
                          {"volume", "m3"},
                          {"solid", "m3"},
                          {"fraction"},
                          {"particles", "", ColumnFormat::integer},
                          {"overlap_share"}}};
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const RegionShape region = clipped(regions[k], snapshot.domain);
    const double volume = region_volume(region);
    const Content content = content_of(region, snapshot);
    const double twice = content.solid > 0 ? counted_twice(region, snapshot, context) / content.solid : no_value;
    table.rows.push_back(
        {static_cast<double>(k), volume, content.solid, content.solid / volume, content.particles, twice});
  }
  result.tables.push_back(std::move(table));
}

}  // namespace packstone::analysis
