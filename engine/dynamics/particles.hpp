// The particles' state as structure of arrays.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"

namespace packstone::engine {

/// Three arrays that together hold one vector a particle.
struct VectorArray {
  std::vector<double> x, y, z;

  void resize(std::size_t n) {
    for (auto* component : {&x, &y, &z}) component->resize(n, 0.0);
  }
  Vec3 get(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3& v) {
    x[i] = v[0];
    y[i] = v[1];
    z[i] = v[2];
  }
};

/// What contact forces see of a particle at one instant; kept twice, one read while the other is written.
struct Kinematics {
  VectorArray position;          ///< [m]; outside the box by less than the list's margin along periodic axes
  VectorArray velocity;          ///< [m/s]
  VectorArray angular_velocity;  ///< [rad/s]; empty where nothing turns

  void resize(std::size_t n, bool rotates) {
    position.resize(n);
    velocity.resize(n);
    if (rotates) angular_velocity.resize(n);
  }
};

/// Everything a particle keeps from step to step, ordered by id.
struct Particles {
  Kinematics now, next;
  VectorArray half_velocity;            ///< half a step after `now`'s instant before it is advanced [m/s]
  VectorArray half_angular_velocity;    ///< the same, turning [rad/s]
  std::vector<double> radius;           ///< at full size [m]
  std::vector<double> inverse_mass;     ///< at full size [1/kg]
  std::vector<double> inverse_inertia;  ///< at full size, of 2/5 m R^2 [1/(kg m2)]
  std::vector<std::uint16_t> material;
  std::vector<std::int32_t> type;

  std::size_t size() const { return radius.size(); }
};

/// Radii as a share of full size; 1 and 0 outside a growth filling.
struct Growth {
  double scale = 1;
  double rate = 0;  ///< [1/s]
};

}  // namespace packstone::engine
