// The elastic contact of two spheres: Hertz, J. reine angew. Math. 92 (1881) 156; Zhong et al., Acta Phys. Sin. 58
// (2009), eqs [10]-[12].
#pragma once

#include "engine/contact/normal_force.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// F = K xi^(3/2), K = 4/3 sqrt(R_eff) E_eff: what the laws for elastic spheres share.
struct Hertzian {
  /// K [N/m^(3/2)] of a modulus E_eff [Pa].
  template <class T>
  [[gnu::always_inline]] static T stiffness(const T& modulus, const PairSize<T>& size) {
    using simd::square_root;
    return T(4.0 / 3) * square_root(size.effective_radius) * modulus;
  }

  /// Stored energy [J], of coefficients with a stiffness K.
  template <class Coefficients, class T, class Kept>
  [[gnu::always_inline]] static T energy(const Coefficients& pair, const T& overlap, const Kept& /*kept*/) {
    using simd::square_root;
    return T(2.0 / 5) * pair.stiffness * overlap * overlap * square_root(overlap);
  }
};

}  // namespace packstone::engine
