#include "engine/filling/random_places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>

#include "core/geometry.hpp"
#include "core/random.hpp"
#include "engine/filling/placing.hpp"

namespace packstone::engine {

namespace {

constexpr int most_trials = 20000;  ///< for one particle

/// Spheres placed so far, in one grid a class of sizes; each class is half the size of the one before.
class PlacedSpheres {
 public:
  PlacedSpheres(const Domain& domain, double largest_radius) : domain_(domain), largest_(largest_radius) {}

  bool touches_none(const Vec3& p, double radius) const {
    for (const Level& level : levels_) {
      const double reach = radius + level.largest;
      int low[3], high[3];
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = cell_of(level, p[axis] - reach, axis);
        high[axis] = cell_of(level, p[axis] + reach, axis);
        if (domain_.periodic[axis] && high[axis] - low[axis] + 1 > level.cells[axis]) {
          low[axis] = 0;
          high[axis] = level.cells[axis] - 1;
        }
      }
      for (int i = low[0]; i <= high[0]; ++i) {
        for (int j = low[1]; j <= high[1]; ++j) {
          for (int k = low[2]; k <= high[2]; ++k) {
            if (!free_in(level, {i, j, k}, p, radius)) return false;
          }
        }
      }
    }
    return true;
  }

  /// Radii must not grow from one call to the next.
  void add(const Vec3& p, double radius) {
    const auto index = static_cast<std::size_t>(std::floor(std::log2(largest_ / radius)));
    while (levels_.size() <= index) {
      Level level;
      level.largest = largest_ / std::exp2(static_cast<double>(levels_.size()));
      for (int axis = 0; axis < 3; ++axis) {
        level.cells[axis] = std::max(1, static_cast<int>(domain_.size()[axis] / (2 * level.largest)));
        level.width[axis] = domain_.size()[axis] / level.cells[axis];
      }
      levels_.push_back(level);
    }
    Level& level = levels_[index];
    const int cell[3] = {cell_of(level, p[0], 0), cell_of(level, p[1], 1), cell_of(level, p[2], 2)};
    level.spheres[key_of(level, cell)].push_back({p, radius});
  }

 private:
  struct Sphere {
    Vec3 position;
    double radius;
  };
  struct Level {
    double largest = 0;  ///< radius [m]
    int cells[3] = {1, 1, 1};
    Vec3 width;  ///< of a cell [m]
    std::unordered_map<std::int64_t, std::vector<Sphere>> spheres;
  };

  int cell_of(const Level& level, double x, int axis) const {
    return static_cast<int>(std::floor((x - domain_.min[axis]) / level.width[axis]));
  }

  std::int64_t key_of(const Level& level, const int (&cell)[3]) const {
    std::int64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      int c = cell[axis];
      if (domain_.periodic[axis]) c = (c % level.cells[axis] + level.cells[axis]) % level.cells[axis];
      key = key * (level.cells[axis] + 2) + (c + 1);  // spheres on an open face may lie in the cell beyond
    }
    return key;
  }

  bool free_in(const Level& level, const int (&cell)[3], const Vec3& p, double radius) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain_.periodic[axis] && (cell[axis] < -1 || cell[axis] > level.cells[axis])) return true;
    }
    const auto found = level.spheres.find(key_of(level, cell));
    if (found == level.spheres.end()) return true;
    return std::all_of(found->second.begin(), found->second.end(),
                       [&](const Sphere& s) { return domain_.separation(p, s.position).norm() >= radius + s.radius; });
  }

  Domain domain_;
  double largest_;
  std::vector<Level> levels_;
};

}  // namespace

StartingState randomly_placed_particles(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  StartingState start = unplaced_particles(scene);
  std::vector<std::size_t> order(start.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return start.radius[a] > start.radius[b]; });
  PlacedSpheres placed(domain, start.radius[order.front()]);
  const Region region = region_of(scene, domain);
  double volume = 0;
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::size_t id = order[n];
    const double radius = start.radius[id];
    Random random(static_cast<std::uint64_t>(scene.seed), RandomStream::filling_position, id);
    bool found = false;
    for (int trial = 0; trial < most_trials && !found; ++trial) {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(region.min[axis], region.max[axis]);
      found = has_room(p, radius, region, domain, boundaries) && placed.touches_none(p, radius);
      if (found) start.position[id] = domain.wrapped(p);
    }
    if (!found) {
      scene.fail(
          "filling",
          fmt::format("{} of {} particles found a place without overlap, a solid fraction of {:.3f} of the "
                      "region; random places end near 0.38 for equal spheres: enlarge the region, take fewer, or "
                      "let them grow (kind = \"growth\")",
                      n, start.size(), volume / (region.max - region.min).prod()));
    }
    placed.add(start.position[id], radius);
    volume += sphere_volume(radius);
  }
  return start;
}

}  // namespace packstone::engine
