// Two spheres, or a sphere and the floor, that meet head on.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "hand_made.hpp"

namespace packstone::engine::testing {

struct HeadOn {
  double restitution = 0;
  double contact_time = 0;     ///< in whole steps [s]
  double largest_overlap = 0;  ///< [m]
  double momentum_change = 0;  ///< over the momentum of one body
};

/// Effective mass of two spheres of 1200 kg/m3, one of 20 mm [kg].
inline double effective_mass(double second_radius) {
  const double m = 1200 * 4.0 / 3.0 * std::numbers::pi * std::pow(0.02, 3);
  const double M = m * std::pow(second_radius / 0.02, 3);
  return m * M / (m + M);
}

/// Two spheres that meet at a speed [m/s], from a gap [m]; the heavier one, if any, is the second.
inline HeadOn collide(const Scene& scene, double speed, double second_radius, double dt, double gap = 1e-5) {
  HandMade pair(scene,
                {{Vec3(0.4, 0.5, 0.5), Vec3(0.6 * speed, 0, 0)},
                 {Vec3(0.4 + 0.02 + second_radius + gap, 0.5, 0.5), Vec3(-0.4 * speed, 0, 0), second_radius}},
                dt);
  const Vec3 before = pair.momentum();
  HeadOn outcome;
  Recorder recorder;
  recorder.velocity.resize(2);
  recorder.force.resize(2);
  const auto touching = [&](const StepSums& s) { return s.particle_contacts > 0; };
  std::int64_t contact_steps = 0;
  constexpr std::int64_t most_steps = 10000000;  // a pair that never parts fails the checks
  for (std::int64_t n = 0; n < most_steps; ++n) {
    const StepSums sums = pair.step(&recorder);
    outcome.largest_overlap = std::max(outcome.largest_overlap, sums.largest_overlap_share * 0.02);
    contact_steps += touching(sums);
    if (contact_steps > 0 && !touching(sums)) break;
  }
  outcome.restitution = (pair.velocity(1) - pair.velocity(0)).x() / speed;
  outcome.contact_time = static_cast<double>(contact_steps) * dt;
  outcome.momentum_change = (pair.momentum() - before).norm() / (pair.mass(0) * 0.6 * speed);
  return outcome;
}

}  // namespace packstone::engine::testing
