// Exact volume that two overlapping spheres share.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry.hpp"

namespace packstone::analysis {

/// Volume of the intersection of two spheres whose centres are a distance d = r1 + r2 - overlap apart [m3]:
///   V = pi o^2 (d^2 + 2 d (r1 + r2) - 3 (r1 - r2)^2) / (12 d),  o = overlap;
/// 0 without overlap, the smaller sphere when one holds the other.
/// Source: Weisstein, "Sphere-Sphere Intersection", MathWorld, eq. 16 (two caps on a common base).
inline double lens_volume(double r1, double r2, double overlap) {
  if (overlap <= 0) return 0;
  const double d = r1 + r2 - overlap;
  if (d <= std::abs(r1 - r2)) return sphere_volume(std::min(r1, r2));
  const double difference = r1 - r2;
  return std::numbers::pi * overlap * overlap * (d * d + 2 * d * (r1 + r2) - 3 * difference * difference) / (12 * d);
}

}  // namespace packstone::analysis
