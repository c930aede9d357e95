// Drives a scene through time: filling, gravity, steps, recording, monitoring. Knows nothing of files.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.hpp"
#include "core/run_moment.hpp"
#include "core/run_verdict.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/filling/pouring.hpp"
#include "engine/filling/starting_state.hpp"
#include "engine/gravity.hpp"
#include "engine/monitor.hpp"
#include "engine/overdamped_scales.hpp"
#include "engine/stages.hpp"
#include "engine/time_step.hpp"

namespace packstone::engine {

/// What a simulation tells its caller, and asks of it. Each may be empty.
struct SimulationEvents {
  std::function<void(const Snapshot&)> snapshot;
  std::function<void(const std::vector<std::string>& columns, const std::vector<double>& row)> history;
  /// The state in which the run is stopped, offenders marked, before RunFailure is thrown.
  std::function<void(const Snapshot&)> failure;
  /// Called now and then.
  std::function<void(std::int64_t step, std::int64_t steps, double time)> progress;
  /// Asked every step; true ends the run with Interrupted, after save.
  std::function<bool()> should_stop;
  /// Asked every step: whether to save now; again until it has been done.
  std::function<bool()> save_is_due;
  /// Keeps the state, which the function given writes. At the end of every stage as well.
  std::function<void(const RunMoment&, const std::function<void(Archive&)>& state)> save;
};

class Simulation {
 public:
  /// Checks what can be known before the run. Throws InputError located in the scene.
  explicit Simulation(const Scene& scene);
  /// From particles that are in already, in place of the scene's filling.
  Simulation(const Scene& scene, const StartingState& start);
  /// From where a run of the same scene was saved; what it was filled from is not needed any more. Throws InputError
  /// where it cannot have been the same.
  Simulation(const Scene& scene, Archive& saved);

  /// Runs to the scene's end, from wherever it is, on the threads OpenMP is set to. Throws RunFailure where it has to
  /// be stopped, Interrupted when asked to. Snapshots have the same bits for any number of threads.
  void run(const SimulationEvents& events);

  const std::vector<std::string>& warnings() const { return warnings_; }
  /// What warnings say of the run itself, in parts.
  const std::vector<RunVerdict>& doubts() const { return doubts_; }
  /// Completes a verdict by what only the state tells and hands out that state. Throws RunFailure.
  [[noreturn]] void fail(RunVerdict verdict, const SimulationEvents& events) const;
  /// The scene as it is run: "auto" replaced by what was chosen.
  const Scene& scene() const { return scene_; }
  /// Those still to be poured included.
  std::int64_t particle_count() const {
    return static_cast<std::int64_t>(pouring_ ? pouring_->all().size() : particles_.size());
  }
  /// Those that are in.
  std::int64_t present_count() const { return static_cast<std::int64_t>(particles_.size()); }
  const Population& population() const { return population_; }
  const StepLimit& step_limit() const { return limit_; }
  /// Of overdamped motion.
  const std::optional<OverdampedScales>& overdamped() const { return scales_; }
  IntegratorWork work() const { return dynamics_->work(); }
  /// How it ended: at rest or not, and how nearly; empty unless that is known.
  const std::string& ending() const { return ending_; }
  /// Whether the last stage had come to rest, as the scene defines it, when last seen.
  bool at_rest() const { return stages_.at_rest(); }
  /// What that was told by: the root-mean-square speed [m/s], of overdamped motion the unbalanced force.
  double unrest() const { return unrest_; }
  /// Where the particles that are in are and how they move.
  StartingState state() const;
  /// All that a run goes on from, with the same bits.
  void archive(Archive& a);
  /// Of all particles, those still to be poured included [kg], and their volume at full size [m3].
  double total_mass() const;
  double solid_volume() const;
  /// content_hash of the file the particles came from; empty for growth.
  const std::string& filling_hash() const { return filling_hash_; }
  /// Unless rest ends a stage before its time.
  std::int64_t steps() const { return stages_.last_step(); }
  /// How far run() has come.
  std::int64_t steps_done() const { return steps_done_; }
  /// Wall time spent in steps, lists of neighbours included, files and measures not [s].
  double loop_seconds() const { return loop_seconds_; }
  /// Of it in building lists of neighbours [s].
  double list_seconds() const { return list_seconds_; }
  /// How often the neighbour list was built.
  std::int64_t list_builds() const { return dynamics_->neighbours().builds(); }

 private:
  Simulation(const Scene& scene, Boundaries&& boundaries, std::unique_ptr<Pouring>&& pouring);
  /// The start is needed no longer than here: the particles take over.
  Simulation(const Scene& scene, Boundaries&& boundaries, std::unique_ptr<Pouring>&& pouring,
             const StartingState& start);

  void run_steps(const SimulationEvents& events);
  /// Of particles that hardly move, whatever pushes them [J].
  double energy_noise() const;
  /// Of the particles that are in [kg].
  double present_mass() const;
  double time_at(std::int64_t step) const { return static_cast<double>(step) * dt_; }
  bool wants(OutputField field) const;
  void account(const StepSums& sums, double share);
  /// Between two steps, or two of an integrator's own: saves if it is wanted or due, and stops when asked to.
  void pause(bool wanted, const SimulationEvents& events);
  /// Step `number` as far as its instant: pouring, forces, what is recorded. False when it was the last.
  bool look(std::int64_t number, Recorder& recorder, const SimulationEvents& events);
  /// What brings the particles to the next instant. False when it has paused on the way.
  bool go_on(std::int64_t number, const SimulationEvents& events);
  std::unique_ptr<Dynamics> make_dynamics();
  /// poured: particles have come in since the step before.
  StepSums step(std::int64_t number, bool poured, Recorder* recorder);
  /// Whether particles came in.
  bool pour(double time);
  void begin_stage(std::int64_t number);
  void check_poured(std::int64_t number) const;
  void record(std::int64_t number, const StepSums& sums, const Recorder& recorder, bool want_snapshot,
              const SimulationEvents& events);
  Snapshot snapshot(std::int64_t number, const Recorder& recorder) const;
  /// With all that belongs to particles whatever they do.
  Snapshot described(std::int64_t number) const;
  /// Position, radius, container: what every snapshot and the bed's measure need.
  Snapshot geometry(std::int64_t number) const;

  std::vector<std::string> warnings_;
  std::vector<RunVerdict> doubts_;
  Population population_;
  std::optional<OverdampedScales> scales_;  ///< none of Newtonian motion
  StepLimit limit_;
  double dt_ = 0;  ///< of overdamped motion: between two looks
  Scene scene_;
  Domain domain_;
  std::string scene_text_;
  std::string scene_hash_;
  std::string filling_hash_;
  Boundaries boundaries_;
  Gravity gravity_;
  std::unique_ptr<Pouring> pouring_;  ///< none where all particles are there from the start
  Stages stages_;
  std::int64_t steps_done_ = 0;
  double loop_seconds_ = 0;
  double list_seconds_ = 0;
  Particles particles_;
  std::unique_ptr<Dynamics> dynamics_;
  Monitor monitor_;
  double unrest_ = 0;
  std::string ending_;
  EnergyAccount account_;  ///< what has passed through up to the step's beginning
};

/// The particles of a simulation that was saved.
StartingState saved_particles(Archive& saved);

}  // namespace packstone::engine
