#include "engine/detection/margin_policy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace packstone::engine {

namespace {

// Measured in a settled bed of equal spheres, docs/performance.md; only their ratio decides.
constexpr double step_share_per_radius = 2.2;  ///< by which margins of one radius lengthen the list, and so a step
constexpr double steps_per_build = 13;         ///< that take as long as building the list
constexpr double least_size_share = 0.01;
constexpr double largest_size_share = 0.4;
constexpr double first_size_share = 0.05;
constexpr double longest_life = 5000;    ///< [steps]
constexpr double slowest_calming = 0.5;  ///< factor on the agitation from one list to the next
constexpr std::int64_t first_look = 64;  ///< [steps]

}  // namespace

Margins MarginPolicy::balanced(double agitation, double dt, double mean_speed) const {
  const double growth = step_share_per_radius * (agitation + mean_speed);
  const double life = std::min(std::sqrt(steps_per_build * dt / std::max(growth, 1e-300)), longest_life * dt);
  return {std::clamp(agitation * life, least_size_share, largest_size_share), life};
}

Margins MarginPolicy::next(double dt, double mean_speed) {
  mean_speed_ = mean_speed;
  if (fixed_ || agitation_ < 0) {
    margins_ = {fixed_.value_or(first_size_share), std::min(steps_per_build, longest_life) * dt};
  } else {
    margins_ = balanced(agitation_, dt, mean_speed);
  }
  return margins_;
}

void MarginPolicy::learn(double used, std::int64_t steps, double dt) {
  if (steps == 0 || !std::isfinite(used)) return;
  const double measured = margins_.size_share * used / (static_cast<double>(steps) * dt);
  agitation_ = std::max(measured, slowest_calming * agitation_);
}

bool MarginPolicy::worth_renewing(double used, std::int64_t steps, double dt) const {
  if (fixed_ || steps < first_look || !std::has_single_bit(static_cast<std::uint64_t>(steps))) return false;
  const double agitation = margins_.size_share * used / (static_cast<double>(steps) * dt);
  const Margins better = balanced(agitation, dt, mean_speed_);
  const double saved = margins_.size_share - better.size_share;
  return step_share_per_radius * saved * static_cast<double>(steps) > steps_per_build;
}

}  // namespace packstone::engine
