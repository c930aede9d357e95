// Solid fraction of the bed away from walls, floor and surface.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/blocks.hpp"
#include "analysis/mean_diameter.hpp"
#include "analysis/packing/fractions.hpp"
#include "analysis/packing/images.hpp"

namespace packstone::analysis {

namespace {

constexpr double most_blocks = 10;

/// Solid volume of equal blocks, one above the other, of a column [m3].
std::vector<double> solid_by_block(const RegionShape& column, int axis, std::size_t blocks, const Snapshot& snapshot) {
  const BoxRegion box = bounds(column);
  const double bottom = box.min[axis], thickness = (box.max[axis] - bottom) / static_cast<double>(blocks);
  std::vector<RegionShape> block;
  for (std::size_t k = 0; k < blocks; ++k) {
    const double lower = bottom + thickness * static_cast<double>(k);
    block.push_back(between(column, axis, lower, k + 1 < blocks ? lower + thickness : box.max[axis]));
  }
  const double highest = static_cast<double>(blocks - 1);
  return bins_in_blocks(snapshot.size(), blocks, [&](Eigen::VectorXd& sum, std::size_t i) {
    const double r = snapshot.radius[i];
    for_each_image(snapshot.domain, snapshot.position[i], r, box, [&](const Vec3& image) {
      const double from = std::floor((image[axis] - r - bottom) / thickness);
      const double to = std::floor((image[axis] + r - bottom) / thickness);
      for (double k = std::max(from, 0.0); k <= std::min(to, highest); ++k) {
        const auto b = static_cast<std::size_t>(k);
        sum[b] += volume_in_region(block[b], image, r);
      }
    });
  });
}

}  // namespace

void add_interior(MeasureResult& result, const Snapshot& snapshot, const Context& context, const Interior& interior) {
  const std::string margin = fmt::format("{:g}", context.options.interior_margin);
  Quantity fraction{.key = "interior_fraction",
                    .label = "interior solid fraction",
                    .definition =
                        "solid volume (exact parts of spheres, overlaps counted twice) over volume of the interior: "
                        "the upright column at least " +
                        margin +
                        " mean diameters (sum d^4 / sum d^3) from side walls, floor, planes, other boundaries' boxes, "
                        "closed ends of the domain and the lowest point of the surface (bed_height, highest spheres in "
                        "squares 2 diameters wide); uncertainty: standard error over up to 10 equal blocks of its "
                        "height, at least one mean diameter thick"};
  Quantity volume{.key = "interior_volume",
                  .label = "volume of the interior",
                  .unit = "m3",
                  .definition = "of the region of interior_fraction"};
  if (!interior.shape) {
    result.quantities.push_back(not_applicable(fraction, interior.reason));
    result.quantities.push_back(not_applicable(volume, interior.reason));
    return;
  }
  const int axis = context.frame.axis;
  const BoxRegion box = bounds(*interior.shape);
  const double diameter = volume_mean_diameter(snapshot.radius);
  const double blocks = std::clamp(std::floor((box.max[axis] - box.min[axis]) / diameter), 1.0, most_blocks);
  volume.value = region_volume(*interior.shape);
  double mean = 0, squares = 0;
  const auto solid = solid_by_block(*interior.shape, axis, static_cast<std::size_t>(blocks), snapshot);
  for (double v : solid) mean += v / *volume.value;
  for (double v : solid) squares += std::pow(v / (*volume.value / blocks) - mean, 2);
  fraction.value = mean;
  if (blocks > 1) fraction.uncertainty = std::sqrt(squares / (blocks - 1) / blocks);
  result.quantities.push_back(fraction);
  result.quantities.push_back(volume);
}

}  // namespace packstone::analysis
