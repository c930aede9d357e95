// Hysteretic damping: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [17], [18], model V.
#pragma once

#include "engine/contact/normal_force.hpp"

namespace packstone::engine {

/// F_n = k xi (1 + g sgn(xi_dot)), 0 <= g < 1; restitution sqrt((1-g)/(1+g)) at any speed.
/// The force jumps by 2 g k xi where the rate changes sign, so that a bed at rest keeps a residual jitter.
struct Hysteretic {
  struct Pair {
    double stiffness = 0;  ///< k [N/m]
    double damping = 0;    ///< g
  };

  /// overlap [m] > 0; rate of overlap [m/s]; the masses do not enter.
  static NormalForce force(const Pair& pair, double overlap, double rate, double /*inverse_mass_sum*/) {
    const double elastic = pair.stiffness * overlap;
    const double sign = static_cast<double>(rate > 0) - static_cast<double>(rate < 0);
    return {elastic, pair.damping * sign * elastic};
  }

  /// Stored energy [J].
  static double energy(const Pair& pair, double overlap) { return 0.5 * pair.stiffness * overlap * overlap; }
};

}  // namespace packstone::engine
