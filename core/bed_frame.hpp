// Where up is, where the floor is, how high every particle stands.
#pragma once

#include <vector>

#include "core/snapshot.hpp"

namespace packstone {

/// The bed seen along its height.
struct BedFrame {
  int axis = 2;                ///< of the height
  double sign = 1;             ///< +1 when up is the positive direction of the axis
  double floor = 0;            ///< coordinate of the floor along the axis [m]
  double area = 0;             ///< cross-section perpendicular to up that particles can fill [m2]
  bool periodic = false;       ///< the domain repeats along up: no floor, no surface; heights count from its lower face
  double extent = 0;           ///< of the domain along up [m]
  std::vector<double> height;  ///< (N) of the centres above the floor [m]

  /// Height of the highest point of any sphere [m]; 0 without particles.
  double top(const std::vector<double>& radius) const;
};

/// Up is opposite to the largest component of gravity, +z without gravity. The floor is the highest plane or flat floor
/// of a boundary whose normal points up (within rounding), else the lower face of the domain. The cross-section is the
/// smallest of the domain's and those that boundaries with an upright axis enclose, as if each held all particles; what
/// else stands in it takes nothing off. Throws InputError when the domain has no cross-section.
BedFrame bed_frame(const Snapshot& snapshot);

}  // namespace packstone
