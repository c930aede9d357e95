// Watches a run and stops it, with the cause in physical terms, before wrong numbers get out.
#pragma once

#include <string>
#include <vector>

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

  double mechanical() const { return kinetic + elastic + attractive; }
  double dissipated() const { return dissipated_normal + dissipated_tangential + dissipated_resistance; }
  double input() const { return starting + growth_work + gravity_work + wall_work; }
  /// What nothing accounts for; 0 in exact arithmetic with an infinitely small step.
  double error() const { return mechanical() + dissipated() - input(); }
};

class Monitor {
 public:
  /// dt: the run's time step, recommended_dt: the one that its messages advise [s]; energy_noise: below which energies
  /// are rounding [J].
  Monitor(const Scene& scene, const Domain& domain, double dt, double recommended_dt, double energy_noise)
      : scene_(scene), domain_(domain), dt_(dt), recommended_dt_(recommended_dt), energy_noise_(energy_noise) {}

  /// Every position is a number and inside the domain, but for open faces, and nothing goes so far in a step that it
  /// could go through a boundary. Throws RunError naming the particle.
  void check_positions(const Particles& particles, double time) const;

  /// Throws RunError naming the pair when a contact was beyond the overlap limit.
  void check_overlap(const StepSums& sums, const Particles& particles, double time) const;

  /// No boundary may go so far in a step that it could go through particles. Throws RunError.
  void check_boundaries(const Boundaries& boundaries, double smallest_radius, double time) const;

  /// Kinetic and elastic energy must not rise unless growth, gravity or a boundary puts it in or the particles came
  /// with it. Throws RunError.
  void check_energy(const EnergyAccount& account, double time);

  /// At the end: warns when the account does not close.
  void check_account(const EnergyAccount& account, std::vector<std::string>& warnings) const;

 private:
  /// Gravity brings back what leaves through this open face.
  bool pulled_back(int face) const;
  std::string step_advice() const;
  std::string overlap_advice(double time) const;

  const Scene& scene_;
  Domain domain_;
  double dt_;
  double recommended_dt_;
  double energy_noise_;
  double largest_input_ = 0;  ///< [J]
  double lowest_unfed_ = 0;   ///< least of mechanical energy less input so far [J]
};

}  // namespace packstone::engine
