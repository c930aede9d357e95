#include "engine/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "core/bed.hpp"
#include "core/bed_frame.hpp"
#include "core/error.hpp"
#include "core/geometry.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/dynamics/overdamped.hpp"
#include "engine/filling/filling.hpp"
#include "engine/filling/growth.hpp"
#include "engine/filling/population.hpp"
#include "engine/force_resolution.hpp"
#include "engine/history_row.hpp"
#include "engine/snapshot_fields.hpp"
#include "engine/static_friction.hpp"
#include "engine/stopwatch.hpp"

namespace packstone::engine {

namespace {

constexpr std::int64_t progress_steps = 100;  ///< steps between two reports of progress

bool asks(const std::function<bool()>& question) { return question && question(); }

void check_periodic_sides(const Scene& scene, const Domain& domain, double largest_radius) {
  const double least = NeighbourList::least_periodic_side(largest_radius, scene.contact.van_der_waals.range());
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain.periodic[axis] || domain.size()[axis] >= least) continue;
    scene.fail("domain",
               fmt::format("the periodic side along {} is {:.4g} m; particles of radius {:g} m need at least {:.4g} m, "
                           "so that none meets another twice",
                           axis_names[axis], domain.size()[axis], largest_radius, least));
  }
}

/// Those that are there when the run begins.
StartingState first_particles(const Scene& scene, const Boundaries& boundaries, Pouring* pouring) {
  if (!pouring) return fill(scene, scene.box(), boundaries);
  StartingState first = pouring->take(0, 0, Particles{}, boundaries);
  if (first.size() == 0) {
    scene.fail("filling",
               "no particle found a place in the region that it is to be poured from: boundaries leave no room "
               "in it, or it is smaller than a particle");
  }
  return first;
}

constexpr const char* particles_part = "particles";

/// By id.
StartingState state_of(const Particles& particles, const Domain& domain) {
  StartingState state;
  state.position.resize(particles.size());
  state.velocity.resize(particles.size());
  state.angular_velocity.assign(particles.size(), Vec3::Zero());
  state.radius.resize(particles.size());
  state.type.resize(particles.size());
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) {
    if (!particles.is_particle(slot)) continue;
    const Row& row = particles.now.rows[slot];
    const std::int32_t id = particles.id[slot];
    state.position[id] = domain.wrapped(row.position);
    state.velocity[id] = row.velocity;
    if (particles.turns()) state.angular_velocity[id] = particles.now.spins[slot].angular_velocity;
    state.radius[id] = row.radius;
    state.type[id] = particles.type[slot];
  }
  return state;
}

/// Solid volume over the domain's: the fraction where the domain repeats along up and there is no bed.
double solid_share(const Snapshot& s) {
  double solid = 0;
  for (const double radius : s.radius) solid += sphere_volume(radius);
  return solid / s.domain.size().prod();
}

/// Whether friction keeps a force from step to step.
bool has_tangential_spring(const Scene& scene) {
  const TangentialModel law = scene.contact.tangential;
  return rotates(scene) && law != TangentialModel::coulomb && law != TangentialModel::haff_werner;
}

/// Of the particles that a file holds.
void warn_of_ignored_velocities(const StartingState& start, std::vector<std::string>& warnings) {
  const bool any =
      std::any_of(start.velocity.begin(), start.velocity.end(), [](const Vec3& v) { return !v.isZero(0); });
  if (any)
    warnings.push_back("filling.path: the file's velocities are left aside: in overdamped motion forces set them");
}

std::string how_it_ends(double unbalanced, bool at_rest, double time) {
  return fmt::format("{} at t = {:.6g} s: the largest unbalanced force is {:.3g} of {}",
                     at_rest ? "at rest" : "not at rest", time, unbalanced,
                     "the weight, or without gravity of the mean contact force");
}

/// The scene with "auto" replaced.
Scene with_choices_made(Scene scene, double dt, const StepLimit& limit) {
  if (scene.dynamics.overdamped()) return scene;
  scene.dynamics.time_step = dt;
  if (scene.dynamics.contact_velocity == ContactVelocity::automatic) {
    // docs/physics.md: the step's velocity damps friction's springs, the half step's shakes hysteretic beds.
    const bool half_step =
        scene.contact.normal != NormalModel::hysteretic && (has_tangential_spring(scene) || dt > limit.recommended);
    scene.dynamics.contact_velocity = half_step ? ContactVelocity::half_step : ContactVelocity::step;
  }
  return scene;
}

}  // namespace

Simulation::Simulation(const Scene& scene)
    : Simulation(scene, Boundaries(scene, scene.box()),
                 scene.filling.kind == FillingKind::pour ? std::make_unique<Pouring>(scene) : nullptr) {}

Simulation::Simulation(const Scene& scene, const StartingState& start)
    : Simulation(scene, Boundaries(scene, scene.box()), nullptr, start) {}

Simulation::Simulation(const Scene& scene, Archive& saved)
    : Simulation(scene, Boundaries(scene, scene.box()),
                 scene.filling.kind == FillingKind::pour ? std::make_unique<Pouring>(scene) : nullptr,
                 saved_particles(saved)) {
  archive(saved);
}

Simulation::Simulation(const Scene& scene, Boundaries&& boundaries, std::unique_ptr<Pouring>&& pouring)
    : Simulation(scene, std::move(boundaries), std::move(pouring), first_particles(scene, boundaries, pouring.get())) {}

Simulation::Simulation(const Scene& scene, Boundaries&& boundaries, std::unique_ptr<Pouring>&& pouring,
                       const StartingState& start)
    : population_(population_of(scene, pouring ? pouring->all() : start)),
      scales_(scene.dynamics.overdamped() ? std::optional(overdamped_scales(scene, population_)) : std::nullopt),
      limit_(scales_ ? overdamped_step_limit(*scales_) : engine::step_limit(scene, population_)),
      dt_(scales_ ? look_interval(scene) : checked_time_step(scene, limit_, warnings_)),
      scene_(with_choices_made(scene, dt_, limit_)),
      domain_(scene.box()),
      filling_hash_(start.source_hash),
      boundaries_(std::move(boundaries)),
      gravity_(scene),
      pouring_(std::move(pouring)),
      stages_(scene, dt_),
      particles_(make_particles(scene_, start)),
      dynamics_(make_dynamics()),
      monitor_(scene_, domain_, scales_ ? scene.dynamics.time_step.value_or(0) : dt_, limit_.recommended,
               energy_noise()) {
  if (scales_) {
    check_overdamped_step(scene, *scales_, warnings_);
    warn_of_ignored_velocities(start, warnings_);
    // Else walls would take particles for having come from where those velocities point back to.
    for (Row& row : particles_.now.rows) row.velocity.setZero();
  }
  check_periodic_sides(scene, domain_, largest_radius(population_));
  warn_of_lost_weight(scene, population_, warnings_);
  warn_without_static_friction(scene, population_, warnings_);
  scene_text_ = to_toml(scene_);
  scene_hash_ = packstone::scene_hash(scene_);
  for (const auto& [path, interval] : {std::pair{"output.interval", scene.output.interval},
                                       {"output.history_interval", scene.output.history_interval}}) {
    if (interval < dt_) scene.fail(path, fmt::format("{:g} s is shorter than the time step, {:g} s", interval, dt_));
  }
}

std::unique_ptr<Dynamics> Simulation::make_dynamics() {
  if (!scales_) return make_newtonian(scene_, domain_, boundaries_);
  return make_overdamped(scene_, domain_, boundaries_, chosen_integrator(scene_), 2 / scales_->bed_limit);
}

double Simulation::energy_noise() const {
  if (scales_) {
    constexpr double smallest_fall = 1e-6;  // radii, of all
    const double fall =
        total_mass() * scene_.gravity.acceleration.norm() * smallest_fall * smallest_radius(population_);
    // By which a step's places may be off, root mean square over the particles.
    const double overlap = *scene_.dynamics.tolerance * smallest_radius(population_);
    return std::max(fall, 0.5 * scales_->stiffness * overlap * overlap * static_cast<double>(particle_count()));
  }
  constexpr double slowest = 1e-9;                                                            // radii a step
  const double fall = scene_.gravity.present ? dt_ * scene_.gravity.acceleration.norm() : 0;  // in one step
  const double speed = slowest * smallest_radius(population_) / dt_ + fall;
  return 0.5 * total_mass() * speed * speed;
}

double Simulation::present_mass() const { return std::accumulate(particles_.mass.begin(), particles_.mass.end(), 0.0); }

double Simulation::total_mass() const { return pouring_ ? pouring_->total_mass() : present_mass(); }

double Simulation::solid_volume() const {
  double total = 0;
  if (pouring_) {
    for (const double radius : pouring_->all().radius) total += sphere_volume(radius);
    return total;
  }
  for (std::size_t slot = 0; slot < particles_.slots(); ++slot) {
    if (particles_.is_particle(slot)) total += sphere_volume(particles_.now.rows[slot].radius);
  }
  return total;
}

StartingState Simulation::state() const { return state_of(particles_, domain_); }

void Simulation::archive(Archive& a) {
  a.begin(particles_part);
  a(filling_hash_, particles_);
  a.begin("dynamics");
  dynamics_->archive(a, particles_);
  a.begin("simulation");
  a(steps_done_, boundaries_, stages_, monitor_, account_, warnings_, ending_);
  if (pouring_) a(*pouring_);
}

StartingState saved_particles(Archive& saved) {
  std::string filling_hash;
  Particles particles;
  saved.begin(particles_part);
  saved(filling_hash, particles);
  StartingState state = state_of(particles, Domain{});
  state.source_hash = filling_hash;
  return state;
}

bool Simulation::wants(OutputField field) const {
  return std::count(scene_.output.fields.begin(), scene_.output.fields.end(), field) > 0;
}

void Simulation::account(const StepSums& sums, double share) {
  account_.dissipated_normal += share * sums.dissipated_normal;
  account_.dissipated_tangential += share * sums.dissipated_tangential;
  account_.dissipated_resistance += share * sums.dissipated_resistance;
  account_.growth_work += share * sums.growth_work;
  account_.wall_work += share * sums.wall_work;
}

StepSums Simulation::step(std::int64_t number, bool poured, Recorder* recorder) {
  const double time = time_at(number);
  const Stopwatch clock;
  StepInput input{dt_, growth_at(scene_, time), Vec3::Zero(), scene_.monitor.overlap_limit, 0.0};
  if (scene_.dynamics.contact_velocity == ContactVelocity::step) input.velocity_lead = 0.5 * dt_;
  input.gravity = gravity_.at(time);
  boundaries_.go_to(time, dt_, input.velocity_lead);
  monitor_.check_boundaries(boundaries_, smallest_radius(population_), time);
  if (poured || dynamics_->outdated(input.growth)) {
    monitor_.check_positions(particles_, time);
    const Stopwatch list_clock;
    dynamics_->rebuild(particles_, input.growth, dt_);
    list_seconds_ += list_clock.seconds();
  }
  const StepSums sums = dynamics_->advance(particles_, input, recorder);
  loop_seconds_ += clock.seconds();
  monitor_.check_overlap(sums, particles_, time);
  boundaries_.push(dynamics_->wall_loads(), input.gravity, time, dt_);
  return sums;
}

bool Simulation::go_on(std::int64_t number, const SimulationEvents& events) {
  const Stopwatch clock;
  StepInput input;
  input.dt = dt_;
  const std::function<bool()> should_pause = [&] {
    return asks(events.should_stop) || (events.save && asks(events.save_is_due));
  };
  input.should_pause = &should_pause;
  const std::optional<StepSums> passed = dynamics_->go_on(particles_, input, time_at(number));
  loop_seconds_ += clock.seconds();
  if (!passed) return false;
  account(*passed, 1);
  account_.gravity_work += passed->gravity_work;
  monitor_.check_overlap(*passed, particles_, time_at(number + 1));
  return true;
}

void Simulation::pause(bool wanted, const SimulationEvents& events) {
  const double time = dynamics_->paused_at().value_or(time_at(steps_done_));
  const bool stop = asks(events.should_stop);
  if (events.save && (wanted || stop || asks(events.save_is_due))) {
    events.save({0, steps_done_, time}, [this](Archive& a) { archive(a); });
  }
  if (stop) throw Interrupted(fmt::format("stopped at t = {:.6g} s, step {}", time, steps_done_));
}

bool Simulation::pour(double time) {
  if (!pouring_ || time == 0) return false;
  // Overdamped motion is not looked at often.
  const StartingState more = pouring_->take(time, scales_ ? 0 : dt_, particles_, boundaries_);
  append_particles(particles_, scene_, more);
  for (std::size_t i = 0; i < more.size(); ++i) {
    account_.starting += 0.5 * particles_.mass[particles_.slots() - more.size() + i] * more.velocity[i].squaredNorm();
  }
  return more.size() > 0;
}

void Simulation::begin_stage(std::int64_t number) {
  stages_.next(number);
  boundaries_.begin_stage(scene_.stages[stages_.current()].name, time_at(number));
}

void Simulation::check_poured(std::int64_t number) const {
  if (!pouring_ || pouring_->over()) return;
  RunVerdict verdict{FailureKind::filling_incomplete};
  verdict.time = time_at(number);
  verdict.quantity = "particles poured";
  verdict.value = static_cast<double>(pouring_->poured());
  verdict.limit = static_cast<double>(pouring_->all().size());
  verdict.what =
      fmt::format("{} of the {} particles have been poured by the end", pouring_->poured(), pouring_->all().size());
  verdict.cause = "the others found no room in the region";
  verdict.advice =
      fmt::format("enlarge it, let particles leave it faster (filling.velocity), run longer, or take fewer{}",
                  scene_.filling.portions ? ", or wait for the last portion to come to rest" : "");
  verdict.remedies = {{"dynamics.duration"}, {"filling.velocity"}};
  throw RunFailure(verdict);
}

void Simulation::run(const SimulationEvents& events) {
  try {
    run_steps(events);
  } catch (const RunFailure& failure) {
    fail(failure.verdict(), events);
  }
}

void Simulation::run_steps(const SimulationEvents& events) {
  Recorder recorder;
  if (steps_done_ == 0 && !scene_.stages.empty()) boundaries_.begin_stage(scene_.stages.front().name, 0);
  for (;; ++steps_done_) {
    if (!dynamics_->paused_at()) {
      pause(steps_done_ == stages_.end(), events);
      if (!look(steps_done_, recorder, events)) return;
    }
    while (!go_on(steps_done_, events)) pause(false, events);
  }
}

bool Simulation::look(std::int64_t number, Recorder& recorder, const SimulationEvents& events) {
  if (number == stages_.end() && !stages_.is_last()) begin_stage(number);
  const bool poured = pour(time_at(number));
  const bool last = number == stages_.end();
  const bool want_snapshot = last || number % steps_in(scene_.output.interval, dt_) == 0;
  const bool want_history = want_snapshot || number % steps_in(scene_.output.history_interval, dt_) == 0;
  if (want_history) {
    recorder.want_contacts = (want_snapshot && scene_.output.contacts) ||
                             (scales_ && !scene_.gravity.present);  // whose mean force is wanted
    recorder.velocity.resize(particles_.size());
    recorder.force.resize(particles_.size());
    recorder.angular_velocity.resize(rotates(scene_) ? particles_.size() : 0);
    recorder.angular_acceleration.resize(
        want_snapshot && wants(output_angular_acceleration) ? recorder.angular_velocity.size() : 0);
    recorder.elastic.assign(want_snapshot && wants(output_elastic) ? particles_.size() : 0, 0.0);
    recorder.contacts = {};
  }
  const StepSums sums = step(number, poured, want_history ? &recorder : nullptr);
  if (number > 0) account(sums, 0.5);  // the rates of an instant count half before it and half after
  if (want_history) record(number, sums, recorder, want_snapshot, events);
  if (events.progress && (last || number % progress_steps == 0)) events.progress(number, steps(), time_at(number));
  if (last) {
    check_poured(number);
    return false;
  }
  account(sums, 0.5);
  account_.gravity_work += sums.gravity_work;  // done between this instant and the next
  return true;
}

void Simulation::record(std::int64_t number, const StepSums& sums, const Recorder& recorder, bool want_snapshot,
                        const SimulationEvents& events) {
  const double kinetic = sums.kinetic_translational + sums.kinetic_rotational;
  if (number == 0) account_.starting = kinetic + sums.elastic + sums.attractive;
  EnergyAccount account = account_;
  account.kinetic = kinetic;
  account.elastic = sums.elastic;
  account.attractive = sums.attractive;
  const double time = time_at(number);
  monitor_.check_positions(particles_, time);
  monitor_.check_energy(account, particles_, time);
  if (number == stages_.last_step()) {
    if (const auto doubt = monitor_.check_account(account, time)) {
      doubts_.push_back(*doubt);
      doubts_.back().step = number;
      warnings_.push_back(doubts_.back().message());
    }
  }
  const Snapshot bed = geometry(number);
  const BedFrame frame = bed_frame(bed);
  const std::vector<double> potential = gravitational_energies(particles_, bed, frame, gravity_.acts(time));
  const double gravitational = std::accumulate(potential.begin(), potential.end(), 0.0);
  const BedState state =
      frame.periodic ? BedState{solid_share(bed), 0} : measure_bed(frame.height, bed.radius, frame.area);
  unrest_ = scales_ ? sums.unbalanced_force : std::sqrt(2 * sums.kinetic_translational / present_mass());
  if (pouring_) pouring_->see({frame, bed.radius, recorder.velocity, recorder.force, gravity_.at(time)}, unrest_);
  const bool all_in = time >= scene_.filling.over() && (!pouring_ || pouring_->over()) &&
                      (!scene_.gravity.present || gravity_.acts(time));
  stages_.see(number, unrest_, all_in);
  if (scales_) ending_ = how_it_ends(unrest_, stages_.at_rest(), time);
  if (events.history) {
    events.history(history_columns(scene_),
                   history_row(scene_, {number, time, stages_.current(), account, sums, gravitational, state,
                                        particles_.size(), dynamics_->wall_loads(), boundaries_, dynamics_->work()}));
  }
  if (want_snapshot && events.snapshot) events.snapshot(snapshot(number, recorder));
}

}  // namespace packstone::engine
