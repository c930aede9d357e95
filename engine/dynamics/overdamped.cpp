#include "engine/dynamics/overdamped.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/run_verdict.hpp"
#include "engine/block_sum.hpp"
#include "engine/filling/growth.hpp"

namespace packstone::engine {

namespace {

constexpr double longest_move = 0.25;       ///< of its radius, that a particle may make in a step chosen by tolerance
constexpr double planned_move = 0.2;        ///< of it, at the speed of the step before, or a slower one that it has
constexpr double longest_given_move = 0.5;  ///< in a given step: farther, it could go through a boundary
constexpr double list_share = 0.3;          ///< of its radius, that each particle may move while a list serves
constexpr double growth_in_step = 0.02;     ///< of the full radius
constexpr double most_sinking = 1e-4;       ///< share of the particles that may touch nothing on a way that ends
constexpr double most_longer = 2, most_shorter = 0.2, safety = 0.9;  ///< of a step's length to the one before
/// Over the particles.
struct Extremes {
  double fastest = 0;  ///< radii a second
  double smallest = std::numeric_limits<double>::infinity();

  Extremes& operator+=(const Extremes& o) {
    fastest = std::max(fastest, o.fastest);
    smallest = std::min(smallest, o.smallest);
    return *this;
  }
};

constexpr double shortest_share = 1e-10;  ///< of the time to go: a step so short goes nowhere

}  // namespace

std::unique_ptr<Dynamics> make_overdamped(const Scene& scene, const Domain& domain, Boundaries& boundaries,
                                          Integrator integrator, double bed_rate) {
  auto method = integrator == Integrator::euler ? make_euler(bed_rate)
                : integrator == Integrator::rkc ? make_runge_kutta_chebyshev(bed_rate)
                                                : make_backward_euler(*scene.dynamics.tolerance);
  return std::make_unique<Overdamped>(scene, domain, boundaries, std::move(method));
}

Overdamped::Overdamped(const Scene& scene, const Domain& domain, Boundaries& boundaries,
                       std::unique_ptr<OverdampedMethod> method)
    : scene_(scene), system_(scene, domain, boundaries), method_(std::move(method)) {}

bool Overdamped::outdated(const Growth& growth) const {
  return system_.field().neighbours().outdated(growth) || system_.field().walls().outdated(neighbours());
}

void Overdamped::rebuild(Particles& particles, const Growth& growth, double dt) {
  const double length = length_ > 0 ? std::min(length_, dt) : dt;
  system_.field().rebuild(particles, growth, length, list_share);
  system_.take(particles);
  fresh_ = fresh_ || mobile_ != particles.size();
  mobile_ = particles.size();
}

void Overdamped::renew_list(Particles& particles, double time, double dt, double least_share) {
  system_.field().rebuild(particles, growth_at(scene_, time), dt, least_share);
  system_.take(particles);
}

StepSums Overdamped::advance(Particles& particles, const StepInput& input, Recorder* recorder) {
  StepSums sums = system_.field().find(particles, input, recorder);
  power_ = power_of(sums, input.dt);
  sums.growth_work = sums.wall_work = 0;  // go_on tells them
  if (fresh_ || method_->ends_with_velocity()) {
    for_each_index(particles.slots(), [&](std::size_t s) {
      if (!particles.is_particle(s)) return;
      particles.now.rows[s].velocity =
          system_.mobility()[s] * (particles.force.get(s) + particles.mass[s] * input.gravity);
    });
    fresh_ = false;
  }
  if (recorder) record(particles, input, *recorder, sums);
  return sums;
}

void Overdamped::record(const Particles& particles, const StepInput& input, Recorder& recorder, StepSums& sums) const {
  const double gravity = input.gravity.norm();
  double largest = 0;              // over the weight where there is any [N]
  double forces = 0, weights = 0;  // of all [N]
  std::size_t sinking = 0;         // touch nothing
  for (std::size_t s = 0; s < particles.slots(); ++s) {
    if (!particles.is_particle(s)) continue;
    const Vec3 force = particles.force.get(s) + particles.mass[s] * input.gravity;
    const Vec3 velocity = system_.mobility()[s] * force;
    recorder.force[particles.id[s]] = force;
    recorder.velocity[particles.id[s]] = velocity;
    sums.largest_speed_squared = std::max(sums.largest_speed_squared, velocity.squaredNorm());
    if (particles.force.get(s).isZero(0)) ++sinking;
    forces += force.norm();
    weights += particles.mass[s] * gravity;
    largest = std::max(largest, gravity > 0 ? force.norm() / (particles.mass[s] * gravity) : force.norm());
  }
  // On the way to rest a bed of many particles always has one that a stiff contact pushes for an instant. A few small
  // ones that still sink, with their whole weight, are little in the mean.
  const bool some_sink = static_cast<double>(sinking) > most_sinking * static_cast<double>(particles.size());
  sums.unbalanced_force =
      scene_.dynamics.goal == Goal::rest ? std::max(forces / weights, some_sink ? 1.0 : 0.0) : largest;
  if (gravity > 0 || largest == 0) return;
  double sum = 0;
  for (const Vec3& force : recorder.contacts.force) sum += force.norm();
  const auto contacts = static_cast<double>(recorder.contacts.force.size());
  sums.unbalanced_force = contacts > 0 ? largest * contacts / sum : std::numeric_limits<double>::infinity();
}

void Overdamped::read(const Particles& particles) {
  x0_.resize(particles.slots());
  v0_.resize(particles.slots());
  for_each_index(particles.slots(), [&](std::size_t s) {
    const bool there = particles.is_particle(s);
    x0_[s] = there ? particles.now.rows[s].position : Vec3::Zero();
    v0_[s] = there ? particles.now.rows[s].velocity : Vec3::Zero();
  });
}

void Overdamped::write(Particles& particles, const SlotVectors& x, const SlotVectors& v) const {
  for_each_index(particles.slots(), [&](std::size_t s) {
    if (!particles.is_particle(s)) return;
    particles.now.rows[s].position = x[s];
    particles.now.rows[s].velocity = v[s];
  });
}

double Overdamped::longest_step(const Particles& particles, double time, double until) {
  const Extremes found = sum_in_blocks<Extremes>(particles.slots(), Extremes{}, [&](std::size_t s) {
    if (!particles.is_particle(s)) return Extremes{};
    const Row& row = particles.now.rows[s];
    return Extremes{row.velocity.norm() / row.radius, row.radius};
  });
  // What a stiff contact sets moving at an instant is over long before the step is.
  const double fastest = pace_ > 0 ? std::min(found.fastest, pace_) : found.fastest, smallest = found.smallest;
  double longest = std::min(until, method_->stable_step(system_, time));
  if (fastest > 0) longest = std::min(longest, planned_move / fastest);
  const double growth_rate = growth_at(scene_, time).rate;
  if (growth_rate > 0) longest = std::min(longest, growth_in_step / growth_rate);
  for (std::size_t k = 0; k < system_.boundaries().size(); ++k) {
    const Boundaries::Body& body = system_.boundaries()[k];
    if (body.present && body.speed > 0) longest = std::min(longest, planned_move * smallest / body.speed);
  }
  return longest;
}

Overdamped::Moved& Overdamped::Moved::operator+=(const Moved& o) {
  farthest = std::max(farthest, o.farthest);
  share_squared = std::max(share_squared, o.share_squared);
  sum += o.sum;
  heat += o.heat;
  work += o.work;
  return *this;
}

Overdamped::Moved Overdamped::moved(const Particles& particles, double length) const {
  const NeighbourList& list = neighbours();
  const VectorArray& from = list.reference();
  const std::size_t n = particles.slots();
  const Vec3 sum = sum_in_blocks<Vec3>(n, Vec3::Zero(), [&](std::size_t s) {
    return particles.is_particle(s) ? Vec3(x1_[s] - from.get(s)) : Vec3(Vec3::Zero());
  });
  const Vec3 common = sum / static_cast<double>(std::max<std::size_t>(particles.size(), 1));
  Moved all = sum_in_blocks<Moved>(n, Moved{}, [&](std::size_t s) {
    Moved one;
    if (!particles.is_particle(s)) return one;
    const Vec3 step = x1_[s] - x0_[s];
    const double far = step.norm() / particles.now.rows[s].radius;
    one.farthest = std::isfinite(far) ? far : std::numeric_limits<double>::infinity();
    one.share_squared = (x1_[s] - from.get(s) - common).squaredNorm() * list.inverse_margin_squared()[s];
    one.heat = step.squaredNorm() / (length * system_.mobility()[s]);
    one.work = system_.weight(s).dot(step);
    return one;
  });
  all.sum = sum;
  return all;
}

bool Overdamped::list_held(const Particles& particles, const Moved& moved, double time) const {
  const WallList& walls = system_.field().walls();
  const double common = moved.sum.norm() / static_cast<double>(std::max<std::size_t>(particles.size(), 1));
  return moved.share_squared < 1 && walls.travelled() + common <= walls.margin() &&
         growth_at(scene_, time).scale <= neighbours().largest_scale();
}

double Overdamped::next_length(double length, double error) const {
  const double share =
      error > 0 ? safety * std::pow(*scene_.dynamics.tolerance / error, 1.0 / method_->error_order()) : most_longer;
  return length * std::clamp(share, most_shorter, most_longer);
}

void Overdamped::fail_at(const Particles& particles, double time, double length, const Moved& moved) {
  RunVerdict v{FailureKind::non_convergence};
  v.time = time;
  v.quantity = "way in one step over the radius";
  v.value = moved.farthest;
  std::string who = "a particle";
  const auto way = [&](std::size_t s) { return (x1_[s] - x0_[s]).norm() / particles.now.rows[s].radius; };
  for (std::size_t s = 0; s < particles.slots(); ++s) {
    // Of several that are not numbers the first.
    if (!particles.is_particle(s) || way(s) < moved.farthest || !v.particles.empty()) continue;
    v.particles = {{particles.id[s], scene_.particles[particles.type[s]].name}};
    v.place = x0_[s];
    who = told(v.particles.front()) + " at " + told(*v.place);
  }
  if (scene_.dynamics.time_step) {
    v.kind = FailureKind::step_too_long;
    v.limit = longest_given_move;
    v.what = fmt::format("{} moves {:.3g} of its radius in one step of {:.3g} s, more than {:g}", who, v.value, length,
                         v.limit);
    v.cause = fmt::format("the step is beyond what {} can follow here", method_->stable_step(system_, time) < length
                                                                            ? "the explicit scheme's stability"
                                                                            : "the integrator");
    v.advice = "shorten dynamics.time_step or leave it to \"auto\"";
    v.remedies = {{"dynamics.time_step", "auto"}};
  } else {
    v.limit = longest_move;
    v.what =
        fmt::format("no step is short enough, {:.3g} s was not: {} moves {:.3g} of its radius", length, who, v.value);
    v.advice = "look for particles that start inside each other or a boundary";
    v.remedies = {{"filling.path"}};
  }
  throw RunFailure(v);
}

std::optional<double> Overdamped::paused_at() const { return way_ ? std::optional(way_->now) : std::nullopt; }

void Overdamped::archive(Archive& a, Particles& particles) {
  a(length_, pace_, fresh_, power_, mobile_, steps_, rejected_, way_);
  method_->archive(a);
  system_.archive(a, particles);
}

std::optional<StepSums> Overdamped::go_on(Particles& particles, const StepInput& input, double time) {
  const double end = time + input.dt;
  const double given = scene_.dynamics.time_step.value_or(0);
  const double tolerance = *scene_.dynamics.tolerance;
  if (!way_) {
    way_ = Way{time, {}, list_share};
    system_.forget_instant();
  }
  auto& [now, passed, share] = *way_;
  while (now < end) {
    if (input.should_pause && (*input.should_pause)()) return std::nullopt;
    if (outdated(growth_at(scene_, now))) {
      renew_list(particles, now, std::min(length_ > 0 ? length_ : input.dt, end - now), list_share);
    }
    read(particles);
    const double left = end - now;
    double length = given > 0 ? input.dt / std::ceil(input.dt / given) : longest_step(particles, now, input.dt);
    if (given == 0 && length_ > 0) length = std::min(length, length_);
    const double planned = length;
    const bool last = length * (1 + 1e-9) >= left;
    if (last) {
      length = left;
    } else if (given == 0 && 2 * length > left) {
      length = 0.5 * left;
    }
    const Attempt attempt = method_->attempt(system_, {now, length, power_, x0_, v0_, x1_, v1_});
    const Moved step = attempt.solved ? moved(particles, length) : Moved{std::numeric_limits<double>::infinity()};
    const bool short_enough = step.farthest <= (given > 0 ? longest_given_move : longest_move);
    const bool held = attempt.solved && list_held(particles, step, now + length);
    if (!short_enough || !held || (given == 0 && attempt.error > tolerance)) {
      ++rejected_;
      write(particles, x0_, v0_);
      if (given > 0 && !short_enough) fail_at(particles, now, length, step);
      if (!short_enough) {
        length_ = 0.5 * length;
      } else if (given == 0 && attempt.error > tolerance) {
        length_ = next_length(length, attempt.error);
      } else {  // the list served no farther; if it was new, margins were too narrow
        system_.field().neighbours().moved(step.share_squared, step.sum, length);
        share = std::min(2 * share, 1.0);
        renew_list(particles, now, length, share);
        length_ = given > 0 ? 0 : 0.5 * length;
      }
      if (!last && length < shortest_share * input.dt) fail_at(particles, now, length, step);
      continue;
    }
    if (!last && now + length == now) fail_at(particles, now, length, step);  // time would stand still
    write(particles, x1_, v1_);
    system_.field().neighbours().moved(step.share_squared, step.sum, length);
    share = list_share;
    pace_ = step.farthest / length;
    ++steps_;
    passed.dissipated_resistance += step.heat;
    passed.gravity_work += step.work;
    passed.growth_work += attempt.work.growth;
    passed.wall_work += attempt.work.walls;
    power_ = power_of(attempt.sums, length);
    if (!passed.offence) passed.offence = attempt.sums.offence;
    length_ = std::max(next_length(length, attempt.error), length < planned ? planned : 0.0);
    now = last ? end : now + length;
  }
  const StepSums all = passed;
  way_.reset();
  return all;
}

}  // namespace packstone::engine
