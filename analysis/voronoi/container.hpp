// The convex region that Voronoi cells fill: the domain within the boundaries that hold the packing.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone::analysis {

/// Points x with normal . x >= offset.
struct HalfSpace {
  Vec3 normal;        ///< unit vector to the inside
  double offset = 0;  ///< [m]
};

/// An endless round tube, inside.
struct Tube {
  Vec3 centre;        ///< on the axis [m]
  Vec3 axis;          ///< unit vector
  double radius = 0;  ///< [m]
};

struct CellContainer {
  Domain box;                          ///< no periodic side where a boundary crosses it
  std::vector<HalfSpace> planes = {};  ///< those that are no sides of the box
  std::vector<Tube> tubes = {};
  std::vector<std::string> left_out = {};  ///< names and kinds of the boundaries that do not cut

  bool has_volume() const { return box.size().minCoeff() > 0; }
  bool holds(const Vec3& point) const;
};

/// The domain, cut
/// - by planes and by other one-sided boundaries of flat faces that are convex towards the particles, each face
///   extended without end (an open box has no lid),
/// - by one-sided cylinders around the particles, of any axis, extended without end, and by their closed ends,
/// each only where at least 99 % of the centres lie inside: else it does not hold the packing, and is left out, as all
/// other boundaries are. Planes square to an axis move the box's sides. Without a side near, the box ends two largest
/// diameters and a tenth of the packing's extent beyond the outermost centres, so that open space costs nothing.
/// The box has no volume where nothing is left of the domain.
/// centre: (N) [m], N > 0, inside the domain along its periodic axes.
CellContainer cell_container(const Snapshot& snapshot, std::span<const Vec3> centre);

}  // namespace packstone::analysis
