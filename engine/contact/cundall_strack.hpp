// Tangential spring with Coulomb's limit: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [24], [25], model IX;
// Cundall & Strack, Geotechnique 29 (1979) 47.
#pragma once

#include "engine/contact/law.hpp"
#include "engine/contact/tangential_force.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// F_s = -k_s s, with s the tangential displacement since the contact began, kept in the contact plane; the spring
/// slides with the contact where it would exceed mu |F_n|. The force follows the spring, not sgn(v_s) as printed.
struct CundallStrack : WithoutSizes {
  static constexpr bool active = true;
  static constexpr int most_kept = 3;  ///< s [m]
  static constexpr int kept() { return most_kept; }

  template <class T>
  struct Parameters {
    T stiffness;  ///< k_s [N/m]
    T friction;   ///< mu

    static constexpr int count = 2;
  };

  template <class T>
  using Coefficients = Parameters<T>;

  /// Advances the spring by a step at a sliding velocity to the instant of the forces. With the velocity half a step
  /// before that instant, this is the leapfrog scheme, of second order and without gain or loss. Swapping the bodies
  /// negates normal, velocity and spring, and gives exactly the negated force.
  template <class T, class Kept>
  [[gnu::always_inline]] static TangentialForce<T> advance(const Coefficients<T>& pair, const Slip<T>& slip,
                                                           Kept& kept) {
    using simd::absolute, simd::fused, simd::inverse_sqrt, simd::select, simd::squared_length;
    const simd::Vector<T> displacement = T(slip.dt) * slip.velocity;
    const simd::Vector<T> now = turned_into_plane(kept_vector(kept), slip.normal, displacement);
    const T now_squared = squared_length(now);
    const T limit_force = pair.friction * absolute(slip.normal_force);
    const T share = limit_force * inverse_sqrt(pair.stiffness * pair.stiffness * now_squared);
    TangentialForce<T> f;
    f.sliding = share < T(1.0);
    const T kept_share = select(f.sliding, share, T(1.0));
    const simd::Vector<T> spring = kept_share * now;
    keep_vector(spring, kept);
    f.force = -pair.stiffness * spring;
    const T half_stiffness = T(0.5) * pair.stiffness;
    // Work done on the spring in this step less the change of its energy.
    f.dissipated =
        half_stiffness * (T(1.0) - kept_share) * fused(T(1.0) + kept_share, now_squared, -dot(displacement, now));
    f.elastic = half_stiffness * squared_length(spring);
    return f;
  }
};

}  // namespace packstone::engine
