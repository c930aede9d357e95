#include "engine/contact/head_on.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/contact/mixing.hpp"

namespace packstone::engine {

namespace {

constexpr int steps_to_deepest = 1000;
constexpr int most_steps = 200000;  ///< of bodies that hardly part

}  // namespace

Impact impact_of(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b, const PairSize<double>& size,
                 double speed) {
  const ChosenNormal law(scene.contact);
  ChosenNormal::Parameters<double> pair{};
  set_pair(pair, scene.contact, a, b);
  const auto coefficients = ChosenNormal::coefficients(pair, size);
  const double mass = 1 / size.inverse_mass_sum;

  // An overlap of the impact's order: where the elastic force has done about the work of the kinetic energy.
  double overlap = size.effective_radius;
  for (int halving = 0; halving < 100; ++halving) {
    std::array<double, ChosenNormal::most_kept> untouched{};
    if (law.force(coefficients, overlap, 0.0, untouched).elastic * overlap < mass * speed * speed) break;
    overlap *= 0.5;
  }
  const double dt = overlap / speed / steps_to_deepest;

  Impact impact;
  std::array<double, ChosenNormal::most_kept> kept{};
  double depth = 0, rate = speed, lead = speed;  // lead: the velocity at the step's instant, as the engine estimates it
  for (int step = 0; step < most_steps; ++step) {
    depth += dt * rate;
    if (depth <= 0) {
      impact.duration = dt * step;
      impact.restitution = -rate / speed;
      return impact;
    }
    const double acceleration = -law.force(coefficients, depth, lead, kept).total() * size.inverse_mass_sum;
    rate += dt * acceleration;
    lead = rate + 0.5 * dt * acceleration;
    impact.largest_overlap = std::max(impact.largest_overlap, depth);
  }
  impact.duration = dt * most_steps;
  return impact;
}

}  // namespace packstone::engine
