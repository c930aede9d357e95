#include "engine/rest/rest_run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/geometry.hpp"
#include "engine/overdamped_scales.hpp"
#include "engine/time_step.hpp"

namespace packstone::engine {

namespace {

// docs/rest.md has what these lead to.
constexpr double way_step_over_recommended = 2.5;  ///< where nothing rubs: linear contacts stay stable
constexpr double way_overlap_limit = 0.4;          ///< of the smaller radius: several spheres may press at once
constexpr double energy_at_rest = 5e-5;            ///< kinetic, over the sum of m g d
constexpr std::int64_t most_relaxing_steps = 200000;

constexpr double longer = 4;          ///< duration, where a bed has not come to rest in it
constexpr double rounding_up = 1.05;  ///< of a limit that is to be met once written down

Remedy longer_duration(const Scene& scene) {
  return {"dynamics.duration", fmt::format("{:g} s", longer * scene.dynamics.duration)};
}

/// Long enough that particles that set out to fall do not count as resting: twice the time to that energy in free fall.
double time_of_doubt(double speed, double gravity) { return 2 * speed / gravity; }

/// rest_speed: of a Newtonian way's end [m/s].
Scene way_down(const Scene& scene, const Softening& way, double rest_speed, const StepLimit& full_limit) {
  Scene soft = softened(scene, way.factor);
  DynamicsSpec& d = soft.dynamics;
  if (!d.overdamped()) {
    d.rest_speed = rest_speed;
    d.rest_time = std::max(time_of_doubt(rest_speed, scene.gravity.acceleration.norm()), soft.output.history_interval);
    d.time_step = way_step(scene, way, full_limit);
  }
  soft.monitor.overlap_limit = std::max(soft.monitor.overlap_limit, way_overlap_limit);
  return soft;
}

/// As it was before anything moved, but for the particles' places.
Simulation full_of(const Scene& scene, Archive* saved) {
  return saved && scene.filling.kind != FillingKind::pour ? Simulation(scene, saved_particles(*saved))
                                                          : Simulation(scene);
}

constexpr const char* own_part = "rest";

}  // namespace

double way_step(const Scene& scene, const Softening& way, const StepLimit& full_limit) {
  if (scene.dynamics.overdamped()) return look_interval(scene);
  const bool longer = can_relax(scene) && scene.contact.normal == NormalModel::linear;
  const double chosen = full_limit.recommended * (longer ? way_step_over_recommended : 1.0);
  const double full_step = std::min(chosen, scene.dynamics.time_step.value_or(chosen));
  return std::min({full_step / std::sqrt(way.factor), scene.output.history_interval, scene.output.interval});
}

RestRun::RestRun(const Scene& scene) : RestRun(scene, nullptr) {}

RestRun::RestRun(const Scene& scene, Archive& saved) : RestRun(scene, &saved) {}

RestRun::RestRun(const Scene& scene, Archive* saved)
    : scene_(scene), full_(full_of(scene, saved)), warnings_(full_.warnings()) {
  way_ = softening(scene, full_.population(), full_.solid_volume());
  const bool overdamped = scene.dynamics.overdamped();
  const double rest_speed = overdamped ? 0 : speed_at(*scene.dynamics.way_energy);
  const Scene soft = way_down(scene, way_, rest_speed, full_.step_limit());
  way_step_ = overdamped ? look_interval(scene) : *soft.dynamics.time_step;
  if (saved) {
    saved->begin(own_part);
    archive(*saved);
    auto simulation = std::make_unique<Simulation>(phase_ == Phase::settling ? settling() : soft, *saved);
    (phase_ == Phase::settling ? settling_ : soft_) = std::move(simulation);
    return;
  }
  soft_ = scene.filling.kind == FillingKind::pour ? std::make_unique<Simulation>(soft)
                                                  : std::make_unique<Simulation>(soft, full_.state());
  present_ = soft_->present_count();
}

void RestRun::archive(Archive& a) { a(phase_, done_.steps, done_.list_builds, present_, time_, work_, warnings_); }

SimulationEvents RestRun::saving_all(SimulationEvents events) {
  if (!events.save) return events;
  events.save = [this, save = std::move(events.save)](RunMoment moment, const std::function<void(Archive&)>& state) {
    moment.phase = static_cast<std::int64_t>(phase_);
    moment.step += done_.steps;
    moment.time += time_;
    save(moment, [&](Archive& a) {
      a.begin(own_part);
      archive(a);
      state(a);
    });
  };
  return events;
}

double RestRun::speed_at(double energy_share) const {
  double mass_by_diameter = 0, mass = 0;
  for (std::size_t g = 0; g < full_.population().size(); ++g) {
    const GroupSizes& group = full_.population()[g];
    const double diameter = group.smallest_radius + group.largest_radius;
    const double density = scene_.materials[scene_.material_index(scene_.particles[g].material)].density;
    const double of_group = static_cast<double>(group.count) * density * sphere_volume(0.5 * diameter);
    mass_by_diameter += of_group * diameter;
    mass += of_group;
  }
  return std::sqrt(2 * energy_share * scene_.gravity.acceleration.norm() * mass_by_diameter / mass);
}

void RestRun::count(const Simulation& simulation) {
  done_ += {simulation.steps_done(), simulation.list_builds(), simulation.loop_seconds(), simulation.list_seconds()};
  present_ = simulation.present_count();
  work_ += simulation.work();
}

Snapshot RestRun::told(Snapshot snapshot) const {
  snapshot.scene_text = to_toml(scene());
  snapshot.scene_hash = scene_hash(scene());
  return snapshot;
}

void RestRun::go_down(const SimulationEvents& events) {
  SimulationEvents seen = saving_all(events);
  seen.snapshot = [&](const Snapshot& s) {
    if (events.snapshot) events.snapshot(told(s));
  };
  seen.failure = [&](const Snapshot& s) {
    if (events.failure) events.failure(told(s));
  };
  try {
    soft_->run(seen);
  } catch (...) {
    count(*soft_);
    throw;
  }
  count(*soft_);
  time_ = static_cast<double>(soft_->steps_done() + 1) * way_step();  // the next row is another state
  if (soft_->at_rest()) {
    phase_ = Phase::came_down;
    if (seen.save) seen.save({}, [this](Archive& a) { soft_->archive(a); });
    return;
  }
  const DynamicsSpec& d = scene_.dynamics;
  RunVerdict v{FailureKind::non_convergence};
  v.quantity = d.overdamped() ? "mean unbalanced force over the mean weight" : "root-mean-square speed";
  v.unit = d.overdamped() ? "" : "m/s";
  v.value = soft_->unrest();
  v.limit = d.overdamped() ? *d.rest_force : *soft_->scene().dynamics.rest_speed;
  v.what = fmt::format(
      "the bed has not come down in dynamics.duration: {}",
      d.overdamped()
          ? fmt::format("the mean unbalanced force is still above {:g} of the mean weight (dynamics.rest_force), "
                        "or some particles still sink",
                        *d.rest_force)
          : fmt::format("kinetic energy is still above {:g} of the sum of m g d (dynamics.way_energy)", *d.way_energy));
  v.advice = "give it more time";
  v.remedies = {longer_duration(scene_)};
  soft_->fail(v, seen);
}

Scene RestRun::at_full_stiffness() const {
  Scene full = scene_;
  full.gravity.start = 0;
  if (full.filling.kind != FillingKind::file) full.filling.kind = FillingKind::random;  // all are in, at full size
  full.filling.duration.reset();
  full.dynamics.goal = Goal::motion;
  full.dynamics.time_step = scene().dynamics.time_step;
  return full;
}

SimulationEvents RestRun::counting_on(const SimulationEvents& events,
                                      const std::function<bool(std::int64_t)>& wants) const {
  SimulationEvents on;
  const std::int64_t steps = done_.steps;
  on.snapshot = [this, &events, steps, wants](const Snapshot& s) {
    if (!events.snapshot || !wants(s.step)) return;
    Snapshot later = told(s);
    later.step += steps;
    later.time += time_;
    events.snapshot(later);
  };
  on.history = [this, &events, steps, wants](const std::vector<std::string>& columns, const std::vector<double>& row) {
    if (!events.history || !wants(static_cast<std::int64_t>(row[0]))) return;
    std::vector<double> later = row;
    later[0] += static_cast<double>(steps);
    later[1] += time_;
    events.history(columns, later);
  };
  on.progress = [this, &events, steps](std::int64_t step, std::int64_t all, double time) {
    if (events.progress) events.progress(step + steps, all + steps, time + time_);
  };
  on.failure = [this, &events, steps](const Snapshot& s) {
    if (!events.failure) return;
    Snapshot later = told(s);
    later.step += steps;
    later.time += time_;
    events.failure(later);
  };
  on.should_stop = events.should_stop;
  return on;
}

void RestRun::going_on(const std::function<void()>& part) const {
  const std::int64_t steps = done_.steps;
  try {
    part();
  } catch (const RunFailure& failure) {
    RunVerdict later = failure.verdict();
    later.step = later.step.value_or(0) + steps;
    later.time = later.time.value_or(0) + time_;
    throw RunFailure(later);
  }
}

void RestRun::balance(StartingState state, const SimulationEvents& events) {
  const RelaxationLimits limits{*scene_.dynamics.unbalanced_force, most_relaxing_steps, scene_.monitor.overlap_limit};
  Scene full = at_full_stiffness();
  Relaxation relaxed;
  try {
    relaxed = relax(full, state, limits, events.should_stop);
  } catch (const RunFailure& failure) {
    going_on([&] { Simulation(full, state).fail(failure.verdict(), counting_on(events, {})); });
  }
  done_ += relaxed.work;
  // A step of the scene's own motion, whose beginning is the last row and snapshot: at its end the hysteretic law
  // would already jitter.
  full.dynamics.duration = full.output.interval = full.output.history_interval =
      full_.overdamped() ? full_.overdamped()->contact_time : *full.dynamics.time_step;
  Simulation last(full, state);
  const SimulationEvents on = counting_on(events, [](std::int64_t step) { return step == 0; });
  going_on([&] { last.run(on); });
  present_ = last.present_count();
  const std::string steps =
      full_.overdamped() ? fmt::format("{} steps", work_.steps) : fmt::format("{:.3g} us steps", 1e6 * way_step());
  ending_ = fmt::format(
      "{}: mean net force {:.3g} of the mean contact force, largest {:.3g} weights; {:.3g} of the stiffness and {} for "
      "{:.3g} s, then {} steps of relaxation at full stiffness",
      relaxed.balance.unbalanced <= limits.unbalanced ? "at rest" : "not at rest", relaxed.balance.unbalanced,
      relaxed.balance.largest_over_weight, way_.factor, steps, time_, relaxed.work.steps);
  if (relaxed.balance.unbalanced <= limits.unbalanced) return;
  RunVerdict v{FailureKind::non_convergence};
  v.quantity = "mean net force over the mean contact force";
  v.value = relaxed.balance.unbalanced;
  v.limit = limits.unbalanced;
  v.what = fmt::format(
      "after {} steps of relaxation the mean net force is {:.3g} of the mean contact force, not {:g} "
      "(dynamics.unbalanced_force)",
      relaxed.work.steps, v.value, v.limit);
  const std::string earlier = scene_.dynamics.overdamped() ? "dynamics.rest_force" : "dynamics.way_energy";
  v.advice = fmt::format("raise that, or lower {}", earlier);
  v.remedies = {{"dynamics.unbalanced_force", fmt::format("{:.3g}", rounding_up * v.value)}, {earlier}};
  going_on([&] { last.fail(v, on); });
}

Scene RestRun::settling() const {
  Scene full = at_full_stiffness();
  full.dynamics.duration = std::max(scene_.dynamics.duration - time_, *full.dynamics.time_step);
  if (!full.dynamics.rest_speed) full.dynamics.rest_speed = speed_at(energy_at_rest);
  return full;
}

void RestRun::settle(const SimulationEvents& events) {
  Simulation& last = *settling_;
  const Scene& full = last.scene();
  going_on([&] {
    // The way told the first.
    SimulationEvents on = counting_on(events, [](std::int64_t step) { return step > 0; });
    on.save = saving_all(events).save;
    on.save_is_due = events.save_is_due;
    try {
      last.run(on);
    } catch (...) {
      count(last);
      throw;
    }
    const double seconds = static_cast<double>(last.steps_done()) * *full.dynamics.time_step;
    count(last);
    doubts_ = last.doubts();
    for (const RunVerdict& doubt : doubts_) warnings_.push_back(doubt.message());
    ending_ = fmt::format(
        "{}: {:.3g} of the stiffness and {:.3g} us steps for {:.3g} s, then {:.3g} s of motion at full stiffness",
        last.at_rest() ? "at rest" : "not at rest", way_.factor, 1e6 * way_step(), time_, seconds);
    if (last.at_rest()) return;
    RunVerdict v{FailureKind::non_convergence};
    v.quantity = "root-mean-square speed";
    v.value = last.unrest();
    v.limit = *full.dynamics.rest_speed;
    v.unit = "m/s";
    v.what = fmt::format(
        "the bed has not come to rest in dynamics.duration: the particles' root-mean-square speed is "
        "still above {:.3g} m/s",
        v.limit);
    v.advice = "give it more time";
    v.remedies = {longer_duration(scene_)};
    last.fail(v, on);
  });
}

void RestRun::run(const SimulationEvents& events) {
  if (phase_ == Phase::way) go_down(events);
  if (phase_ == Phase::came_down) {
    const StartingState state = soft_->state();
    soft_.reset();
    if (can_relax(scene_)) return balance(state, events);
    settling_ = std::make_unique<Simulation>(settling(), state);
    phase_ = Phase::settling;
  }
  settle(events);
}

}  // namespace packstone::engine
