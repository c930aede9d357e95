// Linear spring-dashpot: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [5], [6], model I.
#pragma once

#include "core/scene.hpp"
#include "engine/contact/normal_force.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// F_n = k xi + g xi_dot, with xi_dot the overlap's rate, so that the dashpot dissipates (the paper's sign is a
/// misprint). The dashpot lets the force pull shortly before separation; with Release::zero_force the contact ends
/// there instead (Schwager & Poeschel, Granular Matter 9 (2007) 465).
template <Release release>
struct Linear {
  static constexpr int most_kept = 0;
  static constexpr bool plastic = false;
  static constexpr bool attracts = false;
  static constexpr int kept() { return most_kept; }

  template <class T>
  struct Parameters {
    T stiffness;              ///< k [N/m]
    T damping;                ///< g [N s/m], the part that does not depend on the masses
    T damping_per_root_mass;  ///< further damping over sqrt(m_eff), from a given restitution [N s/m/sqrt(kg)]

    static constexpr int count = 3;
  };

  /// Stiffness and dashpot of a pair of particles.
  template <class T>
  struct Coefficients {
    T stiffness;  ///< [N/m]
    T damping;    ///< [N s/m]
  };
  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Parameters<T>& pair, const PairSize<T>& size) {
    using simd::fused, simd::inverse_sqrt;
    return {pair.stiffness, fused(pair.damping_per_root_mass, inverse_sqrt(size.inverse_mass_sum), pair.damping)};
  }

  /// overlap [m] > 0; rate of overlap [m/s].
  template <class T, class Kept>
  [[gnu::always_inline]] static NormalForce<T> force(const Coefficients<T>& pair, const T& overlap, const T& rate,
                                                     Kept& /*kept*/) {
    using simd::larger;
    const T elastic = pair.stiffness * overlap, damping = pair.damping * rate;
    if constexpr (release == Release::zero_force) return {elastic, larger(damping, -elastic)};
    return {elastic, damping};
  }

  /// Stored energy [J].
  template <class T, class Kept>
  [[gnu::always_inline]] static T energy(const Coefficients<T>& pair, const T& overlap, const Kept& /*kept*/) {
    return T(0.5) * pair.stiffness * overlap * overlap;
  }
};

}  // namespace packstone::engine
