// The simulated box: extent, periodic sides, open faces.
#pragma once

#include <array>
#include <cmath>

#include "core/vec3.hpp"

namespace packstone {

/// Axis-aligned box that holds the particles' centres.
struct Domain {
  Vec3 min = Vec3::Zero();                               ///< lower corner [m]
  Vec3 max = Vec3::Ones();                               ///< upper corner [m]
  std::array<bool, 3> periodic = {false, false, false};  ///< periodic along x, y, z

  bool operator==(const Domain&) const = default;

  Vec3 size() const { return max - min; }

  /// Shortest vector from b to a over the periodic images [m].
  Vec3 separation(const Vec3& a, const Vec3& b) const {
    Vec3 d = a - b;
    for (int k = 0; k < 3; ++k) {
      if (!periodic[k]) continue;
      const double length = max[k] - min[k];
      d[k] -= length * std::round(d[k] / length);
    }
    return d;
  }

  /// The image of p inside the box along every periodic axis [m].
  Vec3 wrapped(const Vec3& p) const {
    Vec3 q = p;
    for (int k = 0; k < 3; ++k) {
      if (!periodic[k]) continue;
      const double length = max[k] - min[k];
      q[k] -= length * std::floor((q[k] - min[k]) / length);
      if (q[k] >= max[k]) q[k] = min[k];  // rounding of a tiny negative offset
    }
    return q;
  }
};

}  // namespace packstone
