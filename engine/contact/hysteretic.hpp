// Hysteretic damping: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [17], [18], model V.
#pragma once

#include "engine/contact/law.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// F_n = k xi (1 + g sgn(xi_dot)), 0 <= g < 1; restitution sqrt((1-g)/(1+g)) at any speed.
/// The force jumps by 2 g k xi where the rate changes sign, so that a bed at rest keeps a residual jitter. With a sign
/// speed w the sign is xi_dot/w held within -1 and 1 instead, which comes to rest; restitution then falls below it at
/// speeds that do not exceed w by much.
struct Hysteretic : WithoutSizes {
  static constexpr int most_kept = 0;
  static constexpr bool plastic = false;
  static constexpr bool attracts = false;
  static constexpr int kept() { return most_kept; }

  template <class T>
  struct Parameters {
    T stiffness;           ///< k [N/m]
    T damping;             ///< g
    T inverse_sign_speed;  ///< 1/w [s/m], or steepest_sign

    static constexpr int count = 3;
  };
  /// Stands for 1/w where the sign jumps; finite in single precision too [s/m].
  static constexpr double steepest_sign = 1e30;

  template <class T>
  using Coefficients = Parameters<T>;

  /// overlap [m] > 0; rate of overlap [m/s].
  template <class T, class Kept>
  [[gnu::always_inline]] static NormalForce<T> force(const Coefficients<T>& pair, const T& overlap, const T& rate,
                                                     Kept& /*kept*/) {
    using simd::larger, simd::smaller;
    const T elastic = pair.stiffness * overlap;
    const T sign = larger(T(-1.0), smaller(T(1.0), rate * pair.inverse_sign_speed));
    return {elastic, pair.damping * elastic * sign};
  }

  /// Stored energy [J].
  template <class T, class Kept>
  [[gnu::always_inline]] static T energy(const Coefficients<T>& pair, const T& overlap, const Kept& /*kept*/) {
    return T(0.5) * pair.stiffness * overlap * overlap;
  }
};

}  // namespace packstone::engine
