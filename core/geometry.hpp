// Exact volumes of spheres cut by planes.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace packstone {

inline double sphere_volume(double radius) { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }

/// Moment of inertia of a solid sphere, 2/5 m R^2 [kg m2].
inline double sphere_inertia(double mass, double radius) { return 2.0 / 5.0 * mass * radius * radius; }

/// Volume of the part of a sphere below a plane at signed height h over its centre [m3].
/// h <= -r gives 0, h >= r the whole sphere.
inline double sphere_volume_below(double radius, double h) {
  const double cap = std::clamp(h + radius, 0.0, 2.0 * radius);  // height of the cap that is kept
  return std::numbers::pi * cap * cap * (radius - cap / 3.0);
}

/// Volume of the part of a sphere centred at height z that lies between two heights [m3].
inline double sphere_slab_volume(double radius, double z, double lower, double upper) {
  return sphere_volume_below(radius, upper - z) - sphere_volume_below(radius, lower - z);
}

}  // namespace packstone
