// A plane wall: a body of infinite mass and radius.
#pragma once

#include "core/vec3.hpp"

namespace packstone::engine {

struct Plane {
  Vec3 point;            ///< of the plane [m]
  Vec3 normal;           ///< unit vector to the particles' side
  std::size_t material;  ///< index into the scene's materials

  /// Distance of a point from the plane, positive on the particles' side [m].
  double distance(const Vec3& p) const { return (p - point).dot(normal); }
};

}  // namespace packstone::engine
