// dynamics.goal = "rest": the bed at rest by the cheapest way that keeps its statistics (docs/rest.md).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/rest/relaxation.hpp"
#include "engine/rest/softening.hpp"
#include "engine/simulation.hpp"

namespace packstone::engine {

/// Time step of the softened way down [s]. full_limit: of the scene at full stiffness.
double way_step(const Scene& scene, const Softening& way, const StepLimit& full_limit);

/// A softened fall, then a balance of forces at full stiffness; with friction, whose balance depends on the way, the
/// scene's own motion at full stiffness instead. Seen from outside as a Simulation.
class RestRun {
 public:
  /// Checks what can be known before the run. Throws InputError located in the scene.
  explicit RestRun(const Scene& scene);
  /// As Simulation's.
  RestRun(const Scene& scene, Archive& saved);

  /// As Simulation::run, from wherever it is. Times and steps of the way count on; accounts of energy begin anew at
  /// full stiffness. Throws RunFailure also when the bed has not come down, or not to rest, in the scene's time.
  void run(const SimulationEvents& events);

  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<RunVerdict>& doubts() const { return doubts_; }
  /// At full stiffness, "auto" replaced by what was chosen.
  const Scene& scene() const { return full_.scene(); }
  std::int64_t particle_count() const { return full_.particle_count(); }
  std::int64_t present_count() const { return present_; }
  const std::string& filling_hash() const { return full_.filling_hash(); }
  std::int64_t steps_done() const { return done_.steps; }
  double loop_seconds() const { return done_.loop_seconds; }
  double list_seconds() const { return done_.list_seconds; }
  std::int64_t list_builds() const { return done_.list_builds; }
  /// Of an overdamped way.
  IntegratorWork work() const { return work_; }
  /// What was done and how nearly forces balance.
  const std::string& ending() const { return ending_; }

  const Softening& way() const { return way_; }
  /// Of the way down; between two looks of an overdamped one [s].
  double way_step() const { return way_step_; }

 private:
  /// Relaxation begins anew where it was stopped: it takes the same way again.
  enum class Phase : std::uint8_t { way, came_down, settling };

  RestRun(const Scene& scene, Archive* saved);
  void archive(Archive& a);
  /// Events whose save keeps the state of the run and of the simulation that is under way.
  SimulationEvents saving_all(SimulationEvents events);
  void go_down(const SimulationEvents& events);
  void count(const Simulation& simulation);
  /// Of a part that goes on from the way, failures count steps and times on, too.
  void going_on(const std::function<void()>& part) const;
  /// Of particles whose kinetic energy is this share of the sum of m g d, root mean square by mass [m/s]. d is midway
  /// between a group's smallest and largest.
  double speed_at(double energy_share) const;
  /// Its motion at full stiffness, from where the particles are, under gravity.
  Scene at_full_stiffness() const;
  /// That until they are at rest.
  Scene settling() const;
  void balance(StartingState state, const SimulationEvents& events);
  void settle(const SimulationEvents& events);
  /// The scene's own text in place of that of the simulation that made it.
  Snapshot told(Snapshot snapshot) const;
  /// Events that count steps and times on, for the steps that are wanted.
  SimulationEvents counting_on(const SimulationEvents& events, const std::function<bool(std::int64_t)>& wants) const;

  Scene scene_;
  Simulation full_;  ///< tells what the scene is; is not run
  Softening way_;
  Phase phase_ = Phase::way;
  std::unique_ptr<Simulation> soft_;      ///< until it has come down
  std::unique_ptr<Simulation> settling_;  ///< with friction, after that
  double way_step_ = 0;                   ///< [s]
  std::int64_t present_ = 0;
  double time_ = 0;  ///< at which the way ended [s]
  StepWork done_;
  IntegratorWork work_;
  std::string ending_;
  std::vector<std::string> warnings_;
  std::vector<RunVerdict> doubts_;
};

}  // namespace packstone::engine
