// Watches a run and stops it, with the cause in physical terms, before wrong numbers get out.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.hpp"
#include "core/run_verdict.hpp"
#include "core/scene.hpp"
#include "engine/dynamics/particles.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

/// Energies of one instant, what the particles came with, and what has passed through since the start [J].
struct EnergyAccount {
  double kinetic = 0;
  double elastic = 0;
  double attractive = 0;  ///< of van der Waals' forces, 0 or less
  double starting = 0;    ///< the sum of these at time 0
  double dissipated_normal = 0;
  double dissipated_tangential = 0;
  double dissipated_resistance = 0;
  double growth_work = 0;
  double gravity_work = 0;
  double wall_work = 0;  ///< of moving boundaries

  void archive(Archive& a) {
    a(kinetic, elastic, attractive, starting, dissipated_normal, dissipated_tangential, dissipated_resistance,
      growth_work, gravity_work, wall_work);
  }

  double mechanical() const { return kinetic + elastic + attractive; }
  double dissipated() const { return dissipated_normal + dissipated_tangential + dissipated_resistance; }
  double input() const { return starting + growth_work + gravity_work + wall_work; }
  /// What nothing accounts for; 0 in exact arithmetic with an infinitely small step.
  double error() const { return mechanical() + dissipated() - input(); }
};

/// What it finds it throws as RunFailure, without the step.
class Monitor {
 public:
  /// dt: the run's time step, recommended_dt: the one that its messages advise [s]; energy_noise: below which energies
  /// are rounding [J].
  Monitor(const Scene& scene, const Domain& domain, double dt, double recommended_dt, double energy_noise);

  /// Every position is a number and inside the domain, but for open faces, and nothing goes so far in a step that it
  /// could go through a boundary.
  void check_positions(const Particles& particles, double time) const;

  /// No contact is beyond the overlap limit, no centre behind a boundary.
  void check_overlap(const StepSums& sums, const Particles& particles, double time) const;

  /// No boundary may go so far in a step that it could go through particles.
  void check_boundaries(const Boundaries& boundaries, double smallest_radius, double time) const;

  /// Kinetic and elastic energy must not rise unless growth, gravity or a boundary puts it in or the particles came
  /// with it. particles: at the account's instant.
  void check_energy(const EnergyAccount& account, const Particles& particles, double time);

  /// At the end: what is to be said of an account that does not close.
  std::optional<RunVerdict> check_account(const EnergyAccount& account, double time) const;

  void archive(Archive& a) { a(largest_input_, lowest_unfed_); }

 private:
  /// Share of a radius that a particle, or a boundary beside the smallest, may go in one step.
  static constexpr double longest_step = 0.5;

  /// Without branches: it is asked of every particle at every look. Comparisons with what is not a number are false.
  bool is_sound(const Row& row) const {
    const double way = longest_step * row.radius;
    bool sound = row.velocity.squaredNorm() * dt_ * dt_ <= way * way;
    for (int k = 0; k < 3; ++k) sound &= (row.position[k] >= lowest_[k]) & (row.position[k] <= highest_[k]);
    return sound;
  }
  /// By how much a place is beyond a face, less what an open face allows; below 0 where it is not [m].
  double beyond(int face, const Vec3& place) const;
  bool is_open(int face) const;
  NamedParticle named(const Particles& particles, std::size_t slot) const;
  /// The slots, most of a rank first, become the offenders.
  void accuse(RunVerdict& verdict, const Particles& particles, std::vector<std::size_t> slots,
              const std::function<double(std::size_t slot)>& rank) const;
  /// The particles that hold most of the kinetic energy become the offenders. Returns what share of it they hold.
  double accuse_fastest(RunVerdict& verdict, const Particles& particles) const;

  RunVerdict not_numbers(const Particles& particles, const std::vector<std::size_t>& slots) const;
  RunVerdict too_fast(const Particles& particles, const std::vector<std::size_t>& slots) const;
  RunVerdict lost(const Particles& particles, const std::vector<std::size_t>& slots) const;

  /// Gravity brings back what leaves through this open face.
  bool pulled_back(int face) const;
  bool step_is_long() const { return dt_ > recommended_dt_; }
  void advise_step(RunVerdict& verdict) const;
  void advise_on_overlap(RunVerdict& verdict, const std::vector<int>& materials, double time) const;
  std::string step_advice() const;
  std::string energy_cause() const;

  const Scene& scene_;
  Domain domain_;
  double dt_;
  double recommended_dt_;
  double energy_noise_;
  Vec3 lowest_, highest_;     ///< corners of where centres may be, infinitely far or up to numbers' ends [m]
  double largest_input_ = 0;  ///< [J]
  double lowest_unfed_ = 0;   ///< least of mechanical energy less input so far [J]
};

}  // namespace packstone::engine
