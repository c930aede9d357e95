// Overdamped motion from one look of the simulation to the next, in steps of the integrator's own length.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/dynamics/integrator.hpp"
#include "engine/dynamics/overdamped_system.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

/// The scene's, with the integrator chosen; bed_rate: as in make_euler. The boundaries must outlive it; they are
/// brought to the instants of steps.
std::unique_ptr<Dynamics> make_overdamped(const Scene& scene, const Domain& domain, Boundaries& boundaries,
                                          Integrator integrator, double bed_rate);

class Overdamped final : public Dynamics {
 public:
  Overdamped(const Scene& scene, const Domain& domain, Boundaries& boundaries,
             std::unique_ptr<OverdampedMethod> method);

  void rebuild(Particles& particles, const Growth& growth, double dt) override;
  StepSums advance(Particles& particles, const StepInput& input, Recorder* recorder) override;
  /// Throws RunFailure where a given time step is too long, or none is short enough.
  std::optional<StepSums> go_on(Particles& particles, const StepInput& input, double time) override;
  std::optional<double> paused_at() const override;
  void archive(Archive& a, Particles& particles) override;
  bool outdated(const Growth& growth) const override;
  const std::vector<WallLoad>& wall_loads() const override { return system_.field().wall_loads(); }
  const NeighbourList& neighbours() const override { return system_.field().neighbours(); }
  IntegratorWork work() const override { return {steps_, rejected_, system_.evaluations()}; }

 private:
  /// What a step has done to the particles, as shares of their radii or of the list's margins.
  struct Moved {
    double farthest = 0;  ///< of a particle, over its radius; infinite if not a number
    double share_squared = 0;
    Vec3 sum = Vec3::Zero();
    double heat = 0;  ///< against the resistance [J]
    double work = 0;  ///< of gravity [J]

    Moved& operator+=(const Moved& o);
  };

  /// How far go_on has come.
  struct Way {
    double now = 0;  ///< [s]
    StepSums passed;
    double share = 0;  ///< of its radius, that each particle may move at least while the next list serves

    void archive(Archive& a) { a(now, passed, share); }
  };

  void read(const Particles& particles);
  void write(Particles& particles, const SlotVectors& x, const SlotVectors& v) const;
  void record(const Particles& particles, const StepInput& input, Recorder& recorder, StepSums& sums) const;
  void renew_list(Particles& particles, double time, double dt, double least_share);
  /// Longest step that this instant allows, of control by tolerance [s].
  double longest_step(const Particles& particles, double time, double until);
  Moved moved(const Particles& particles, double length) const;
  bool list_held(const Particles& particles, const Moved& moved, double time) const;
  double next_length(double length, double error) const;
  [[noreturn]] void fail_at(const Particles& particles, double time, double length, const Moved& moved);

  Scene scene_;
  OverdampedSystem system_;
  std::unique_ptr<OverdampedMethod> method_;
  double length_ = 0;       ///< of the next step, as far as tolerance goes [s]; 0: not known yet
  double pace_ = 0;         ///< of the particle that went farthest in the last step [radii/s]
  bool fresh_ = true;       ///< particles have come in: the rows' velocities are not those of a step
  DrivenWork power_;        ///< at the instant [W]
  std::size_t mobile_ = 0;  ///< particles when they were last looked at
  std::int64_t steps_ = 0, rejected_ = 0;
  std::optional<Way> way_;  ///< none between two calls that arrive
  SlotVectors x0_, v0_, x1_, v1_;
};

}  // namespace packstone::engine
