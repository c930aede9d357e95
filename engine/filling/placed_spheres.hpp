// Spheres that have a place, found by where they are.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/domain.hpp"

namespace packstone::engine {

/// In one grid a class of sizes; each class is half the size of the one before.
class PlacedSpheres {
 public:
  /// largest_radius: of all that will be added [m].
  PlacedSpheres(const Domain& domain, double largest_radius) : domain_(domain), largest_(largest_radius) {}

  bool touches_none(const Vec3& p, double radius) const;

  void add(const Vec3& p, double radius);

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

  int cell_of(const Level& level, double x, int axis) const;
  std::int64_t key_of(const Level& level, const int (&cell)[3]) const;
  bool free_in(const Level& level, const int (&cell)[3], const Vec3& p, double radius) const;

  Domain domain_;
  double largest_;
  std::vector<Level> levels_;
};

}  // namespace packstone::engine
