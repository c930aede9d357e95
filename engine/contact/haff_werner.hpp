// Viscous friction up to Coulomb's limit: Haff & Werner, Powder Technol. 48 (1986) 239; Zhong et al., Acta Phys. Sin.
// 58 (2009), eq. [23], model VIII.
#pragma once

#include "engine/contact/law.hpp"
#include "engine/contact/tangential_force.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// F_s = -min(g_s |v_s|, mu |F_n|) v_s/|v_s|. Without static friction: a contact under load creeps.
struct HaffWerner : WithoutSizes {
  static constexpr int most_kept = 0;

  template <class T>
  struct Parameters {
    T damping;   ///< g_s [N s/m]
    T friction;  ///< mu

    static constexpr int count = 2;
  };

  template <class T>
  using Coefficients = Parameters<T>;

  template <class T, class Kept>
  [[gnu::always_inline]] static TangentialForce<T> advance(const Coefficients<T>& pair, const Slip<T>& slip,
                                                           Kept& /*kept*/) {
    using simd::absolute, simd::inverse_sqrt, simd::larger, simd::select, simd::squared_length;
    const T speed_squared = squared_length(slip.velocity);
    const T limit_force = pair.friction * absolute(slip.normal_force);
    const T at_limit = limit_force * inverse_sqrt(larger(speed_squared, T(no_length_squared)));
    TangentialForce<T> f;
    f.sliding = at_limit < pair.damping;
    const T coefficient = select(f.sliding, at_limit, pair.damping);
    f.force = -coefficient * slip.velocity;
    f.dissipated = coefficient * speed_squared * T(slip.dt);
    f.elastic = T(0.0);
    return f;
  }
};

}  // namespace packstone::engine
