// Hertz contact with a dashpot: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [10]-[14], model II.
#pragma once

#include "engine/contact/hertzian.hpp"
#include "engine/contact/normal_force.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// F_n = K xi^(3/2) + g xi_dot, K = 4/3 sqrt(R_eff) E_eff. g is constant [14], whose restitution falls with the speed;
/// or, from a given restitution, alpha sqrt(m_eff K) xi^(1/4), whose restitution is the same at any speed (Tsuji,
/// Tanaka & Ishida, Powder Technol. 71 (1992) 239).
struct Hertz : Hertzian {
  static constexpr int most_kept = 0;

  template <class T>
  struct Parameters {
    T modulus;  ///< E_eff [Pa]
    T damping;  ///< g [N s/m]
    T alpha;    ///< of the dashpot from a restitution

    static constexpr int count = 3;
  };

  template <class T>
  struct Coefficients {
    T stiffness;                ///< K [N/m^(3/2)]
    T damping;                  ///< g [N s/m]
    T damping_at_unit_overlap;  ///< alpha sqrt(m_eff K) [N s/m^(5/4)]
  };
  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Parameters<T>& pair, const PairSize<T>& size) {
    using simd::square_root;
    const T K = stiffness(pair.modulus, size);
    return {K, pair.damping, pair.alpha * square_root(K / size.inverse_mass_sum)};
  }

  /// overlap [m] > 0; rate of overlap [m/s].
  template <class T, class Kept>
  [[gnu::always_inline]] static NormalForce<T> force(const Coefficients<T>& pair, const T& overlap, const T& rate,
                                                     Kept& /*kept*/) {
    using simd::fused, simd::square_root;
    const T root = square_root(overlap);
    const T elastic = pair.stiffness * root * overlap;
    const T damping = fused(pair.damping_at_unit_overlap, square_root(root), pair.damping) * rate;
    return {elastic, damping};
  }
};

}  // namespace packstone::engine
