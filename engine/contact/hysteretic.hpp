// Hysteretic damping: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [17], [18], model V.
#pragma once

#include <array>

#include "engine/contact/normal_force.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// F_n = k xi (1 + g sgn(xi_dot)), 0 <= g < 1; restitution sqrt((1-g)/(1+g)) at any speed.
/// The force jumps by 2 g k xi where the rate changes sign, so that a bed at rest keeps a residual jitter.
struct Hysteretic {
  template <class T>
  struct Parameters {
    T stiffness;  ///< k [N/m]
    T damping;    ///< g

    static constexpr int count = 2;
    std::array<T, count> values() const { return {stiffness, damping}; }
    template <class Source>
    static Parameters from(Source&& parameter) {
      return {parameter(0), parameter(1)};
    }
  };

  template <class T>
  using Coefficients = Parameters<T>;
  /// The masses do not enter.
  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Parameters<T>& pair, const T& /*inverse_mass_sum*/) {
    return pair;
  }

  /// overlap [m] > 0; rate of overlap [m/s].
  template <class T>
  [[gnu::always_inline]] static NormalForce<T> force(const Coefficients<T>& pair, const T& overlap, const T& rate) {
    using simd::only;
    const T elastic = pair.stiffness * overlap;
    const T damping = pair.damping * elastic;
    return {elastic, only(rate > T(0.0), damping) - only(rate < T(0.0), damping)};
  }

  /// Stored energy [J].
  template <class T>
  [[gnu::always_inline]] static T energy(const Coefficients<T>& pair, const T& overlap) {
    return T(0.5) * pair.stiffness * overlap * overlap;
  }
};

}  // namespace packstone::engine
