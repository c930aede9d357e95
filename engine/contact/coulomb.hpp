// Sliding friction: Zhong et al., Acta Phys. Sin. 58 (2009), eq. [22], model VII.
#pragma once

#include "engine/contact/law.hpp"
#include "engine/contact/tangential_force.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// F_s = -mu |F_n| v_s/|v_s|. It jumps where v_s turns round: a contact at rest chatters and cannot hold a slope.
struct Coulomb : WithoutSizes {
  static constexpr int most_kept = 0;

  template <class T>
  struct Parameters {
    T friction;  ///< mu

    static constexpr int count = 1;
  };

  template <class T>
  using Coefficients = Parameters<T>;

  template <class T, class Kept>
  [[gnu::always_inline]] static TangentialForce<T> advance(const Coefficients<T>& pair, const Slip<T>& slip,
                                                           Kept& /*kept*/) {
    using simd::absolute, simd::inverse_sqrt, simd::only, simd::squared_length;
    const T speed_squared = squared_length(slip.velocity);
    const auto moves = T(no_length_squared) < speed_squared;
    const T inverse_speed = only(moves, inverse_sqrt(speed_squared));
    const T limit_force = pair.friction * absolute(slip.normal_force);
    return {-(limit_force * inverse_speed) * slip.velocity, limit_force * speed_squared * inverse_speed * T(slip.dt),
            T(0.0), moves};
  }
};

}  // namespace packstone::engine
