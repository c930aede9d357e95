// Plastic contact, loaded and unloaded on two stiffnesses: Walton & Braun, J. Rheol. 30 (1986) 949; Zhong et al., Acta
// Phys. Sin. 58 (2009), eq. [16], model IV.
#pragma once

#include "engine/contact/law.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// First loading F_n = k_1 xi; unloading and reloading below the largest overlap so far, xi_max, F_n = k_2 (xi - xi_0),
/// never below 0, with xi_0 = xi_max (1 - k_1/k_2) the plastic deformation. Restitution sqrt(k_1/k_2) at any speed. The
/// deformation is forgotten when the bodies part.
struct WaltonBraun : WithoutSizes {
  static constexpr int most_kept = 1;  ///< xi_max [m]

  template <class T>
  struct Parameters {
    T loading;    ///< k_1 [N/m]
    T unloading;  ///< k_2 >= k_1 [N/m]

    static constexpr int count = 2;
  };

  template <class T>
  using Coefficients = Parameters<T>;

  /// overlap [m] > 0.
  template <class T, class Kept>
  [[gnu::always_inline]] static NormalForce<T> force(const Coefficients<T>& pair, const T& overlap, const T& /*rate*/,
                                                     Kept& kept) {
    using simd::larger;
    const T before = kept[0];
    kept[0] = larger(overlap, before);
    const T steeper = pair.unloading - pair.loading;
    // Of the work on the loading line the share 1 - k_1/k_2 does not come back.
    const T loss = T(0.5) * pair.loading * (steeper / pair.unloading) * (kept[0] - before) * (kept[0] + before);
    return {elastic_force(pair, overlap, kept[0]), T(0.0), loss};
  }

  /// What unloading would give back [J].
  template <class T, class Kept>
  [[gnu::always_inline]] static T energy(const Coefficients<T>& pair, const T& overlap, const Kept& kept) {
    const T force = elastic_force(pair, overlap, kept[0]);
    return T(0.5) * force * force / pair.unloading;
  }

 private:
  template <class T>
  [[gnu::always_inline]] static T elastic_force(const Parameters<T>& pair, const T& overlap, const T& largest) {
    using simd::fused, simd::larger;
    return larger(fused(pair.unloading, overlap, (pair.loading - pair.unloading) * largest), T(0.0));
  }
};

}  // namespace packstone::engine
