#include "engine/monitor.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone::engine {

namespace {

constexpr const char* face_names[face_count] = {"x-", "x+", "y-", "y+", "z-", "z+"};

constexpr double account_share = 0.1;  ///< of the energy put in: an account further off than this is worth a warning

/// Share of a radius that a particle, or a boundary beside the smallest, may go in one step.
constexpr double longest_step = 0.5;

std::string place(const Vec3& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p[0], p[1], p[2]); }

std::string particle(const Scene& scene, const Particles& particles, std::size_t slot) {
  return fmt::format("particle {} ({})", particles.id[slot], scene.particles[particles.type[slot]].name);
}

std::size_t slot_of(const Particles& particles, std::int64_t id) {
  return static_cast<std::size_t>(std::find(particles.id.begin(), particles.id.end(), id) - particles.id.begin());
}

}  // namespace

std::string Monitor::step_advice() const {
  if (scene_.dynamics.overdamped()) {
    return dt_ > 0 ? fmt::format(
                         "dynamics.time_step is {:.3g} s, explicit Euler's limit in a bed is about {:.3g} s; take "
                         "\"auto\", or integrator = \"implicit\"",
                         dt_, recommended_dt_)
                   : fmt::format("dynamics.tolerance is {:g}; try a smaller one", *scene_.dynamics.tolerance);
  }
  return fmt::format("dynamics.time_step is {:.3g} us, recommended is {:.3g} us or less", dt_ * 1e6,
                     recommended_dt_ * 1e6);
}

std::string Monitor::overlap_advice(double time) const {
  if (scene_.filling.kind == FillingKind::file && time == 0) {
    return fmt::format("they overlap so in {}: move them apart there, or raise monitor.overlap_limit",
                       *scene_.filling.path);
  }
  return fmt::format("{}raise {}, or the step is too large: {}",
                     time < scene_.filling.over() ? "lengthen filling.duration, " : "",
                     is_hertzian(scene_.contact.normal) ? "young_modulus" : "normal_stiffness", step_advice());
}

bool Monitor::pulled_back(int face) const {
  const double outward = (face % 2 ? 1 : -1) * scene_.gravity.acceleration[face / 2];
  return scene_.gravity.present && outward < 0;
}

void Monitor::check_positions(const Particles& particles, double time) const {
  const Vec3 side = domain_.size();
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) {
    if (!particles.is_particle(slot)) continue;
    const Vec3 p = particles.now.rows[slot].position;
    if (!p.allFinite()) {
      throw RunError(fmt::format("t = {:.6g} s: the position of {} is not a number; {}", time,
                                 particle(scene_, particles, slot), step_advice()));
    }
    const Row& row = particles.now.rows[slot];
    if (row.velocity.norm() * dt_ > longest_step * row.radius) {
      throw RunError(
          fmt::format("t = {:.6g} s: {} moves {:.3g} m in one step, more than {:g} of its radius, and could go "
                      "through a boundary; its speed is {:.3g} m/s: {}",
                      time, particle(scene_, particles, slot), row.velocity.norm() * dt_, longest_step,
                      row.velocity.norm(), step_advice()));
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (domain_.periodic[axis]) continue;
      for (const int face : {2 * axis, 2 * axis + 1}) {
        const double beyond = face % 2 ? p[axis] - domain_.max[axis] : domain_.min[axis] - p[axis];
        const bool open = std::count(scene_.domain.open.begin(), scene_.domain.open.end(), face) > 0;
        if (open && pulled_back(face)) continue;
        if (beyond <= (open ? side[axis] : 0)) continue;
        throw RunError(fmt::format(
            "t = {:.6g} s: {} left the domain through the face {} at {}; {}", time, particle(scene_, particles, slot),
            face_names[face], place(p),
            open ? "it is more than a domain's length away and nothing pulls it back; close the face with a boundary"
                 : fmt::format("add a boundary there, enlarge the domain, or list \"{}\" in domain.open; if it went "
                               "through a boundary: {}",
                               face_names[face], step_advice())));
      }
    }
  }
}

void Monitor::check_overlap(const StepSums& sums, const Particles& particles, double time) const {
  if (!sums.offence) return;
  const Offence& o = *sums.offence;
  const std::size_t first = slot_of(particles, o.first);
  const Row& row = particles.now.rows[first];
  double radius = row.radius;
  std::string other;
  if (o.second < 0) {
    other = "boundary " + scene_.boundaries[-1 - o.second].name;
  } else {
    const std::size_t second = slot_of(particles, o.second);
    radius = std::min(radius, particles.now.rows[second].radius);
    other = particle(scene_, particles, second);
  }
  throw RunError(fmt::format(
      "t = {:.6g} s: {} and {} overlap by {:.1f} % of the smaller radius at {}, beyond monitor.overlap_limit = {:g} %; "
      "{}",
      time, particle(scene_, particles, first), other, 100 * o.overlap / radius, place(row.position),
      100 * scene_.monitor.overlap_limit, overlap_advice(time)));
}

void Monitor::check_boundaries(const Boundaries& boundaries, double smallest_radius, double time) const {
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const Boundaries::Body& body = boundaries[k];
    const double most = longest_step * smallest_radius;
    if (!body.present || body.speed * dt_ <= most) continue;
    throw RunError(fmt::format(
        "t = {:.6g} s: boundary {} moves {:.3g} m in one step, more than {:g} of the smallest "
        "radius, {:.3g} m, and could go through particles; slow it down, or take a time step of "
        "{:.3g} us or less",
        time, scene_.boundaries[k].name, body.speed * dt_, longest_step, smallest_radius, 1e6 * most / body.speed));
  }
}

void Monitor::check_energy(const EnergyAccount& account, double time) {
  if (!std::isfinite(account.error())) {
    throw RunError(fmt::format("t = {:.6g} s: the energy is not a number; {}", time, step_advice()));
  }
  largest_input_ = std::max(largest_input_, account.starting + std::abs(account.growth_work) +
                                                std::abs(account.gravity_work) + std::abs(account.wall_work));
  // An explicit step beyond its limit swings contacts open and shut, and resistance takes more than there is.
  if (scene_.dynamics.overdamped() &&
      account.error() > std::max(scene_.monitor.energy_tolerance * largest_input_, energy_noise_)) {
    throw RunError(fmt::format(
        "t = {:.6g} s: the motion is unstable: {:.4g} J more than was put in went against resistance, beyond "
        "monitor.energy_tolerance = {:g} of the {:.4g} J put in so far; {}",
        time, account.error(), scene_.monitor.energy_tolerance, largest_input_, step_advice()));
  }
  const double unfed = account.mechanical() - account.input();  // dissipation can only lower it
  lowest_unfed_ = std::min(lowest_unfed_, unfed);
  if (unfed - lowest_unfed_ > std::max(scene_.monitor.energy_tolerance * largest_input_, energy_noise_)) {
    throw RunError(fmt::format(
        "t = {:.6g} s: the energy grows: kinetic and elastic energy rose by {:.4g} J that nothing put in, beyond "
        "monitor.energy_tolerance = {:g} of the {:.4g} J put in so far; {}",
        time, unfed - lowest_unfed_, scene_.monitor.energy_tolerance, largest_input_, step_advice()));
  }
}

void Monitor::check_account(const EnergyAccount& account, std::vector<std::string>& warnings) const {
  if (std::abs(account.error()) <= account_share * largest_input_) return;
  const char* cause =
      scene_.contact.normal == NormalModel::hysteretic
          ? "the sign of hysteretic damping flips from step to step in contacts at rest, so that the step "
            "feeds in what the law takes out"
          : "the step is too large to follow the collisions";
  warnings.push_back(fmt::format("the energy account does not close: {:+.3g} J beside the {:.3g} J put in; {}; {}",
                                 account.error(), largest_input_, cause, step_advice()));
}

}  // namespace packstone::engine
