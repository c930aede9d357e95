// What holds a bed sideways: an upright cylinder or box, planes, or the domain.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "analysis/packing/region.hpp"
#include "core/bed_frame.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// The cross-section of the bed with its place. Round where the boundary of the smallest cross-section is a cylinder,
/// else a rectangle: that of a box, or of the domain, each without what lies behind upright planes along an axis.
struct Container {
  int axis = 2;  ///< along up
  bool round = false;
  Vec3 centre = Vec3::Zero();  ///< a point of the middle line [m]
  double radius = 0;           ///< where round [m]
  Vec3 min = Vec3::Zero();     ///< rectangle across the axis; along it the domain [m]
  Vec3 max = Vec3::Zero();
  std::array<bool, 3> walled = {};      ///< across which axes the rectangle has walls; no: periodic
  std::optional<std::size_t> boundary;  ///< that it is; none: the domain or planes
  std::string unknown;                  ///< why the place is not known; empty where it is

  /// Largest distance of a point from the nearest side wall [m]; 0 where there are none.
  double half_width() const;

  /// Distance of a point inside from the nearest side wall [m].
  double wall_distance(const Vec3& point) const;

  /// All that is at least so far from the side walls, between two coordinates along the axis. Empty where no point is.
  RegionShape column(double distance, double lower, double upper) const;
};

Container container_of(const Snapshot& snapshot, const BedFrame& frame);

}  // namespace packstone::analysis
