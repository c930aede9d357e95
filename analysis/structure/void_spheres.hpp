// The largest empty sphere around a place.
#pragma once

#include <array>
#include <vector>

#include "analysis/point_grid.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// Distance from a place to the nearest surface of a particle or a boundary.
class VoidSpheres {
 public:
  /// The snapshot must hold a particle and outlive this.
  explicit VoidSpheres(const Snapshot& snapshot);

  /// Radius of the largest sphere around the place that overlaps no particle and no boundary [m]; minus the depth
  /// inside a particle. Flat facets stand for curved boundaries, as snapshots store them; the domain's open faces bound
  /// nothing.
  double radius_at(const Vec3& place) const;

 private:
  struct Triangle {
    Vec3 low, high;  // box around it
    std::array<Vec3, 3> corner;
  };
  struct Plane {
    Vec3 point, normal;
  };

  double to_particles(const Vec3& place) const;
  double to_boundaries(const Vec3& place, double nearest) const;

  std::vector<SizeLevel> levels_;
  const Snapshot& snapshot_;
  std::vector<Plane> planes_;
  std::vector<Triangle> triangles_;
  double spacing_;  // of the particles, spread over the domain [m]
};

}  // namespace packstone::analysis
