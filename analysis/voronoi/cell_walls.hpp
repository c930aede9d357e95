// Cuts voro++'s cells by the walls of a container that are no sides of its box.
#pragma once

#include <cmath>
#include <vector>
#include <voro++/voro++.hh>

#include "analysis/voronoi/container.hpp"

namespace packstone::analysis {

/// voro++ compares lengths with fixed tolerances, so it works in units of the mean distance between particles.
struct CellFrame {
  Vec3 origin;
  double unit;  ///< [m]

  Vec3 scaled(const Vec3& p) const { return (p - origin) / unit; }
};

/// Distance of the farthest corner from the particle.
inline double reach(voro::voronoicell& cell) { return std::sqrt(cell.max_radius_squared()) / 2; }  // corners doubled

/// Walls in the units of a frame. A tube is the prism of equal cross-section whose facets keep within 0.1 % of a mean
/// radius of it, where 96 to 4096 facets do.
class CellWalls {
 public:
  /// mean_radius: of the spheres [m].
  CellWalls(const CellContainer& container, const CellFrame& frame, double mean_radius);

  /// Keeps the part of a cell inside the walls. at: the cell's particle, scaled. False when nothing is left.
  bool cut(voro::voronoicell& cell, const Vec3& at) const;

  /// Of the part of a box inside the walls, from the origin to size, scaled.
  double volume_within(const Vec3& size) const;

 private:
  struct Prism {
    Vec3 centre;
    Vec3 first, second;  // across the axis, unit vectors
    int facets = 0;
    double apothem = 0;

    Vec3 normal(int facet) const;
  };

  static bool cut_by_prism(voro::voronoicell& cell, const Vec3& at, const Prism& prism);

  std::vector<HalfSpace> planes_;
  std::vector<Prism> prisms_;
};

}  // namespace packstone::analysis
