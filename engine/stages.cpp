#include "engine/stages.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::engine {

std::int64_t steps_in(double time, double dt) { return std::max<std::int64_t>(1, std::llround(time / dt)); }

Stages::Stages(const Scene& scene, double dt) {
  const bool overdamped = scene.dynamics.overdamped();
  for (const StageSpec& stage : scene.stages) {
    stages_.push_back(
        overdamped ? Stage{steps_in(stage.duration, dt), 0, stage.rest_force.value_or(0)}
                   : Stage{steps_in(stage.duration, dt), steps_in(stage.rest_time, dt), stage.rest_speed.value_or(0)});
  }
  const DynamicsSpec& run = scene.dynamics;
  if (stages_.empty()) {
    stages_.push_back(overdamped
                          ? Stage{steps_in(run.duration, dt), 0, run.rest_force.value_or(0)}
                          : Stage{steps_in(run.duration, dt), steps_in(run.rest_time, dt), run.rest_speed.value_or(0)});
  }
  end_ = stages_.front().steps;
}

std::int64_t Stages::last_step() const {
  std::int64_t step = end_;
  for (std::size_t k = current_ + 1; k < stages_.size(); ++k) step += stages_[k].steps;
  return step;
}

void Stages::next(std::int64_t step) {
  ++current_;
  end_ = step + stages_[current_].steps;
  resting_since_ = -1;
  ended_ = false;
}

void Stages::see(std::int64_t step, double unrest, bool all_in) {
  if (ended_) return;
  const Stage& stage = stages_[current_];
  if (!all_in || !(unrest < stage.rest)) {
    resting_since_ = -1;
    return;
  }
  if (resting_since_ < 0) resting_since_ = step;
  if (step - resting_since_ < stage.rest_steps) return;
  ended_ = true;
  end_ = std::min(end_, step + 1);
}

}  // namespace packstone::engine
