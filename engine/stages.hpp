// The stages of a run, which end after their time or when the bed has come to rest.
#pragma once

#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "core/scene.hpp"

namespace packstone::engine {

/// Steps of dt [s] that a time [s] takes, one at least.
std::int64_t steps_in(double time, double dt);

/// Counts steps. A scene without stages has one, the run.
class Stages {
 public:
  Stages(const Scene& scene, double dt);

  std::size_t current() const { return current_; }
  bool is_last() const { return current_ + 1 == stages_.size(); }
  /// Step with which the current one ends.
  std::int64_t end() const { return end_; }
  /// Step with which the run ends, unless rest ends a stage before its time.
  std::int64_t last_step() const;

  /// Begins the next one at a step.
  void next(std::int64_t step);

  /// At a step at which the particles' unrest is known: their root-mean-square speed [m/s], of overdamped motion the
  /// unbalanced force. all_in: none is still to come.
  void see(std::int64_t step, double unrest, bool all_in);
  /// Whether they were at rest when last seen, as the stage defines it, or rest has ended it: unrest may be a little
  /// more again in the row after.
  bool at_rest() const { return resting_since_ >= 0; }

  void archive(Archive& a) { a(current_, end_, resting_since_, ended_); }

 private:
  struct Stage {
    std::int64_t steps, rest_steps;
    double rest;  ///< below which particles are at rest; 0: never
  };

  std::vector<Stage> stages_;
  std::size_t current_ = 0;
  std::int64_t end_;
  std::int64_t resting_since_ = -1;  ///< step; -1: does not rest
  bool ended_ = false;               ///< the current stage, by rest
};

}  // namespace packstone::engine
