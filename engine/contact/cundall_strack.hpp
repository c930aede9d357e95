// Tangential spring with Coulomb's limit: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [24], [25], model IX;
// Cundall & Strack, Geotechnique 29 (1979) 47.
#pragma once

#include <cmath>

#include "core/vec3.hpp"

namespace packstone::engine {

/// F_s = -k_s s, with s the tangential displacement since the contact began, kept in the contact plane; the spring
/// slides with the contact where it would exceed mu |F_n|. The force follows the spring, not sgn(v_s) as printed.
struct CundallStrack {
  static constexpr bool active = true;

  struct Pair {
    double stiffness = 0;  ///< k_s [N/m]
    double friction = 0;   ///< mu
  };

  struct Force {
    Vec3 force;             ///< on the first body [N]
    double dissipated = 0;  ///< by sliding in this step [J]
    double elastic = 0;     ///< stored in the spring [J]
    bool sliding = false;
  };

  /// Advances the spring [m], which is kept half a step after the instant of the forces, by a step dt [s] at sliding
  /// velocity [m/s] in the contact plane; so the force is of second order in dt. Swapping the bodies negates normal,
  /// velocity and spring, and gives exactly the negated force.
  static Force advance(const Pair& pair, Vec3& spring, const Vec3& normal, const Vec3& sliding_velocity,
                       double normal_force, double dt) {
    const double length = spring.norm();
    Vec3 turned = spring - spring.dot(normal) * normal;
    const double turned_length = turned.norm();
    if (turned_length > 0) turned *= length / turned_length;  // the contact plane turns; the spring keeps its length
    const Vec3 half_step = 0.5 * dt * sliding_velocity;
    Vec3 now = turned + half_step;
    const double limit = pair.friction * std::abs(normal_force) / pair.stiffness;
    const double now_length = now.norm();
    Force f;
    f.sliding = now_length > limit;
    if (f.sliding) {
      const Vec3 slip = now * (1 - limit / now_length);
      now -= slip;
      // Work done on the spring in this step less the change of its energy.
      f.dissipated = pair.stiffness * (0.5 * (now_length * now_length - limit * limit) - half_step.dot(slip));
    }
    f.force = -pair.stiffness * now;
    f.elastic = 0.5 * pair.stiffness * now.squaredNorm();
    spring = now + half_step;
    return f;
  }
};

}  // namespace packstone::engine
