#include "engine/filling/placed_spheres.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::engine {

bool PlacedSpheres::touches_none(const Vec3& p, double radius) const {
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

void PlacedSpheres::add(const Vec3& p, double radius) {
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

int PlacedSpheres::cell_of(const Level& level, double x, int axis) const {
  return static_cast<int>(std::floor((x - domain_.min[axis]) / level.width[axis]));
}

std::int64_t PlacedSpheres::key_of(const Level& level, const int (&cell)[3]) const {
  std::int64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    int c = cell[axis];
    if (domain_.periodic[axis]) c = (c % level.cells[axis] + level.cells[axis]) % level.cells[axis];
    key = key * (level.cells[axis] + 2) + (c + 1);  // spheres on an open face may lie in the cell beyond
  }
  return key;
}

bool PlacedSpheres::free_in(const Level& level, const int (&cell)[3], const Vec3& p, double radius) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain_.periodic[axis] && (cell[axis] < -1 || cell[axis] > level.cells[axis])) return true;
  }
  const auto found = level.spheres.find(key_of(level, cell));
  if (found == level.spheres.end()) return true;
  return std::all_of(found->second.begin(), found->second.end(),
                     [&](const Sphere& s) { return domain_.separation(p, s.position).norm() >= radius + s.radius; });
}

}  // namespace packstone::engine
