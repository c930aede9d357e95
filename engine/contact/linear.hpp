// Linear spring-dashpot: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [5], [6], model I.
#pragma once

#include <cmath>

#include "core/scene.hpp"
#include "engine/contact/normal_force.hpp"

namespace packstone::engine {

/// F_n = k xi + g xi_dot, with xi_dot the overlap's rate, so that the dashpot dissipates (the paper's sign is a
/// misprint). The dashpot lets the force pull shortly before separation; with Release::zero_force the contact ends
/// there instead (Schwager & Poeschel, Granular Matter 9 (2007) 465).
template <Release release>
struct Linear {
  struct Pair {
    double stiffness = 0;              ///< k [N/m]
    double damping = 0;                ///< g [N s/m], the part that does not depend on the masses
    double damping_per_root_mass = 0;  ///< further damping over sqrt(m_eff), from a given restitution [N s/m/sqrt(kg)]
  };

  /// overlap [m] > 0; rate of overlap [m/s]; 1/m_i + 1/m_j [1/kg].
  static NormalForce force(const Pair& pair, double overlap, double rate, double inverse_mass_sum) {
    const double damping = pair.damping + pair.damping_per_root_mass / std::sqrt(inverse_mass_sum);
    NormalForce f{pair.stiffness * overlap, damping * rate};
    if constexpr (release == Release::zero_force) {
      if (f.total() < 0) f.damping = -f.elastic;
    }
    return f;
  }

  /// Stored energy [J].
  static double energy(const Pair& pair, double overlap) { return 0.5 * pair.stiffness * overlap * overlap; }
};

}  // namespace packstone::engine
