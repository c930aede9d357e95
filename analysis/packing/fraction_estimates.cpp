#include "analysis/packing/fraction_estimates.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analysis/blocks.hpp"
#include "analysis/packing/container.hpp"
#include "analysis/packing/images.hpp"
#include "analysis/point_grid.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace packstone::analysis {

namespace {

Vec3 uniform_in(const BoxRegion& box, Random& random) {
  const double x = random.uniform(box.min.x(), box.max.x()), y = random.uniform(box.min.y(), box.max.y());
  return {x, y, random.uniform(box.min.z(), box.max.z())};
}

/// Steps of the recurrence along the axes, in lengths of the box: powers of 1/g, g the root of g^4 = g + 1.
Vec3 even_step() {
  constexpr double g = 1.2207440846057595;
  return {1 / g, 1 / (g * g), 1 / (g * g * g)};
}

/// Places along an axis of the middles of voxels.
struct VoxelAxis {
  double first, edge;
  std::int64_t count;

  double middle(std::int64_t k) const { return first + edge * static_cast<double>(k); }
  /// Of the first middle not below a place, and of the first beyond another.
  std::int64_t from(double low) const {
    return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil((low - first) / edge)));
  }
  std::int64_t to(double high) const {
    return std::min(count, static_cast<std::int64_t>(std::floor((high - first) / edge)) + 1);
  }
};

using VoxelGrid = std::array<VoxelAxis, 3>;

/// Calls visit(middle) for all voxels between two corners.
template <class Visit>
void for_each_voxel(const VoxelGrid& grid, const Vec3& low, const Vec3& high, Visit&& visit) {
  for (std::int64_t x = grid[0].from(low.x()); x < grid[0].to(high.x()); ++x) {
    for (std::int64_t y = grid[1].from(low.y()); y < grid[1].to(high.y()); ++y) {
      for (std::int64_t z = grid[2].from(low.z()); z < grid[2].to(high.z()); ++z) {
        visit(Vec3(grid[0].middle(x), grid[1].middle(y), grid[2].middle(z)));
      }
    }
  }
}

}  // namespace

RegionShape bulk_region(const Snapshot& snapshot, const Context& context) {
  const BedFrame& frame = context.frame;
  if (frame.periodic) return BoxRegion{snapshot.domain.min, snapshot.domain.max};
  if (!(context.bed.height > 0)) throw InputError("there is no bed: all particles lie below the floor");
  const Container container = container_of(snapshot, frame);
  if (!container.unknown.empty()) throw InputError("the bulk's place is not known: " + container.unknown);
  const double from = frame.floor + frame.sign * bulk_lower * context.bed.height;
  const double to = frame.floor + frame.sign * bulk_upper * context.bed.height;
  return container.column(0, std::min(from, to), std::max(from, to));
}

double exact_fraction(const Snapshot& snapshot, const RegionShape& region) {
  const BoxRegion box = bounds(region);
  const double solid = sum_in_blocks<double>(snapshot.size(), 0.0, [&](double& sum, std::size_t i) {
    for_each_image(snapshot.domain, snapshot.position[i], snapshot.radius[i], box,
                   [&](const Vec3& image) { sum += volume_in_region(region, image, snapshot.radius[i]); });
  });
  return solid / region_volume(region);
}

double sampled_fraction(const Snapshot& snapshot, const RegionShape& region, std::size_t points, PointSet set,
                        std::uint64_t seed) {
  const auto levels = size_levels(snapshot.position, snapshot.radius, snapshot.domain);
  const BoxRegion box = bounds(region);
  const Vec3 size = box.max - box.min, step = even_step();
  Random random(seed, RandomStream::fraction_estimate, 0);
  Vec3 share(random.uniform(), random.uniform(), random.uniform());
  std::int64_t held = 0;
  for (std::size_t taken = 0; taken < points;) {
    share += step;
    for (double& s : share) s -= std::floor(s);
    const Vec3 point = set == PointSet::even ? Vec3(box.min + share.cwiseProduct(size)) : uniform_in(box, random);
    if (!contains(region, point)) continue;
    ++taken;
    for (const SizeLevel& level : levels) {
      level.grid.for_each_within(point, level.largest, [&](std::uint32_t row, const Vec3&, double squared) {
        held += squared < snapshot.radius[row] * snapshot.radius[row];
      });
    }
  }
  return static_cast<double>(held) / static_cast<double>(points);
}

double voxel_fraction(const Snapshot& snapshot, const RegionShape& region, double edge, std::uint64_t seed) {
  const BoxRegion box = bounds(region);
  const double voxels = ((box.max - box.min) / edge).prod();
  if (!(voxels <= most_voxels)) {
    throw InputError(
        fmt::format("voxels of {:g} m are {:.2g} in the region; {:g} are the most", edge, voxels, most_voxels));
  }
  Random random(seed, RandomStream::fraction_estimate, 0);
  const auto axis = [&](int k) {
    const double first = box.min[k] + random.uniform() * edge;
    return VoxelAxis{first, edge, static_cast<std::int64_t>(std::ceil((box.max[k] - first) / edge))};
  };
  const VoxelGrid grid = {axis(0), axis(1), axis(2)};
  std::int64_t inside = 0;
  for_each_voxel(grid, box.min, box.max, [&](const Vec3& middle) { inside += contains(region, middle); });
  if (inside == 0) throw InputError(fmt::format("voxels of {:g} m are too large for the region", edge));
  const double held = sum_in_blocks<double>(snapshot.size(), 0.0, [&](double& sum, std::size_t i) {
    const double r = snapshot.radius[i];
    for_each_image(snapshot.domain, snapshot.position[i], r, box, [&](const Vec3& centre) {
      for_each_voxel(grid, centre - Vec3::Constant(r), centre + Vec3::Constant(r), [&](const Vec3& middle) {
        sum += (middle - centre).squaredNorm() < r * r && contains(region, middle);
      });
    });
  });
  return held / static_cast<double>(inside);
}

}  // namespace packstone::analysis
