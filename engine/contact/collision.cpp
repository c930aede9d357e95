#include "engine/contact/collision.hpp"

#include <cmath>
#include <numbers>

namespace packstone::engine {

double undamped_contact_time(double stiffness, double effective_mass) {
  return std::numbers::pi * std::sqrt(effective_mass / stiffness);
}

double linear_restitution(double zeta, Release release) {
  const double damped = std::sqrt(1 - zeta * zeta);  // frequency over the undamped one
  // Phase of the damped oscillation at which the contact ends: overlap back at zero, or force back at zero.
  const double phase = release == Release::zero_overlap
                           ? std::numbers::pi
                           : std::numbers::pi - std::atan2(2 * zeta * damped, damped * damped - zeta * zeta);
  return std::exp(-zeta / damped * phase);
}

double linear_damping_ratio(double restitution, Release release) {
  if (release == Release::zero_overlap) {
    const double log_e = std::log(restitution);
    return -log_e / std::hypot(std::numbers::pi, log_e);
  }
  // Restitution falls with the damping ratio from 1 to exp(-2) at critical damping; smaller ones take zeta near 1.
  double low = 0, high = 1;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (linear_restitution(middle, release) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double hysteretic_restitution(double damping) { return std::sqrt((1 - damping) / (1 + damping)); }

double hysteretic_damping(double e) { return (1 - e * e) / (1 + e * e); }

}  // namespace packstone::engine
