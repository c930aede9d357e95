// What the monitor makes of the energy account.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/monitor.hpp"
#include "engine/slots_where.hpp"

namespace packstone::engine {

namespace {

/// Of the energy put in: an account further off than this is worth a warning. docs/stability.md calls such runs wrong.
constexpr double account_share = 0.02;

constexpr std::size_t most_accused_of_energy = 3;  ///< in which all particles have a part

}  // namespace

double Monitor::accuse_fastest(RunVerdict& verdict, const Particles& particles) const {
  const auto energy = [&](std::size_t slot) {
    return 0.5 * particles.mass[slot] * particles.now.rows[slot].velocity.squaredNorm();
  };
  std::vector<std::size_t> slots = slots_where(particles, [&](std::size_t slot) { return energy(slot) > 0; });
  if (slots.empty()) return 0;
  double all = 0, theirs = 0;
  for (const std::size_t slot : slots) all += energy(slot);
  const auto worst = slots.begin() + static_cast<std::ptrdiff_t>(std::min(slots.size(), most_accused_of_energy));
  std::partial_sort(slots.begin(), worst, slots.end(),
                    [&](std::size_t a, std::size_t b) { return energy(a) > energy(b); });
  slots.erase(worst, slots.end());
  for (const std::size_t slot : slots) theirs += energy(slot);
  accuse(verdict, particles, slots, energy);
  return theirs / all;
}

std::string Monitor::energy_cause() const {
  if (scene_.contact.normal == NormalModel::hysteretic) {
    return "the sign of hysteretic damping flips from step to step in contacts at rest, so that the step feeds in what "
           "the law takes out";
  }
  return "the step is too large to follow the collisions";
}

void Monitor::check_energy(const EnergyAccount& account, const Particles& particles, double time) {
  RunVerdict v{FailureKind::energy_growth};
  v.time = time;
  v.unit = "J";
  if (!std::isfinite(account.error())) {
    v.kind = FailureKind::not_a_number;
    v.quantity = "energy";
    v.value = account.error();
    v.what = "the energy is not a number";
    v.cause = "forces beyond what numbers hold";
    advise_step(v);
    throw RunFailure(v);
  }
  largest_input_ = std::max(largest_input_, account.starting + std::abs(account.growth_work) +
                                                std::abs(account.gravity_work) + std::abs(account.wall_work));
  v.limit = std::max(scene_.monitor.energy_tolerance * largest_input_, energy_noise_);
  // An explicit step beyond its limit swings contacts open and shut, and resistance takes more than there is.
  const bool unstable = scene_.dynamics.overdamped() && account.error() > v.limit;
  const double unfed = account.mechanical() - account.input();  // dissipation can only lower it
  lowest_unfed_ = std::min(lowest_unfed_, unfed);
  const bool grows = unfed - lowest_unfed_ > v.limit;
  if (!unstable && !grows) return;
  const double share = accuse_fastest(v, particles);
  if (unstable) {
    v.kind = FailureKind::overdamped_instability;
    v.quantity = "energy taken by resistance that was not put in";
    v.value = account.error();
    v.what = fmt::format(
        "the motion is unstable: {:.4g} J more than was put in went against resistance, beyond "
        "monitor.energy_tolerance = {:g} of the {:.4g} J put in so far",
        v.value, scene_.monitor.energy_tolerance, largest_input_);
    v.cause = "an explicit step beyond its limit swings contacts open and shut";
  } else {
    v.quantity = "rise of kinetic and elastic energy that nothing put in";
    v.value = unfed - lowest_unfed_;
    v.what = fmt::format(
        "the energy grows: kinetic and elastic energy rose by {:.4g} J that nothing put in, beyond "
        "monitor.energy_tolerance = {:g} of the {:.4g} J put in so far",
        v.value, scene_.monitor.energy_tolerance, largest_input_);
    v.cause = energy_cause();
  }
  if (!v.particles.empty()) {
    v.what += fmt::format("; the fastest are {} at {}", told(v.particles.front()), told(*v.place));
    for (std::size_t k = 1; k < v.particles.size(); ++k) v.what += " and " + told(v.particles[k]);
    if (!unstable) v.what += fmt::format(", with {:.0f} % of the kinetic energy", 100 * share);
  }
  advise_step(v);
  throw RunFailure(v);
}

std::optional<RunVerdict> Monitor::check_account(const EnergyAccount& account, double time) const {
  RunVerdict v{FailureKind::account_open};
  v.time = time;
  v.quantity = "error of the energy account";
  v.value = account.error();
  v.limit = std::max(account_share * largest_input_, energy_noise_);
  v.unit = "J";
  if (std::abs(v.value) <= v.limit) return std::nullopt;
  v.what = fmt::format("the energy account does not close: {:+.3g} J beside the {:.3g} J put in, {:.1f} %", v.value,
                       largest_input_, 100 * std::abs(v.value) / largest_input_);
  v.cause = energy_cause();
  advise_step(v);
  return v;
}

}  // namespace packstone::engine
