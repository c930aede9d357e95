// Viscoelastic spheres: Kuwabara & Kono, Jpn. J. Appl. Phys. 26 (1987) 1230; Brilliantov, Spahn, Hertzsch & Poeschel,
// Phys. Rev. E 53 (1996) 5382; Zhong et al., Acta Phys. Sin. 58 (2009), eq. [15], model III.
#pragma once

#include "engine/contact/hertzian.hpp"
#include "engine/contact/normal_force.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// F_n = K (xi^(3/2) + 3/2 B xi^(1/2) xi_dot), K that of Hertz. Restitution falls with the impact speed v, at low
/// speeds 1 - e ~ v^(1/5).
struct KuwabaraKono : Hertzian {
  static constexpr int most_kept = 0;

  template <class T>
  struct Parameters {
    T modulus;           ///< E_eff [Pa]
    T dissipation_time;  ///< B [s]

    static constexpr int count = 2;
  };

  template <class T>
  struct Coefficients {
    T stiffness;         ///< K [N/m^(3/2)]
    T dissipation_time;  ///< B [s]
  };
  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Parameters<T>& pair, const PairSize<T>& size) {
    return {stiffness(pair.modulus, size), pair.dissipation_time};
  }

  /// overlap [m] > 0; rate of overlap [m/s].
  template <class T, class Kept>
  [[gnu::always_inline]] static NormalForce<T> force(const Coefficients<T>& pair, const T& overlap, const T& rate,
                                                     Kept& /*kept*/) {
    using simd::square_root;
    const T stiffness_times_root = pair.stiffness * square_root(overlap);
    const T elastic = stiffness_times_root * overlap;
    const T damping = T(1.5) * pair.dissipation_time * stiffness_times_root * rate;
    return {elastic, damping};
  }
};

}  // namespace packstone::engine
