#include "engine/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/block_sum.hpp"
#include "engine/filling/growth.hpp"
#include "engine/slots_where.hpp"

namespace packstone::engine {

namespace {

constexpr const char* face_names[face_count] = {"x-", "x+", "y-", "y+", "z-", "z+"};

constexpr double safe_share = 0.9;  ///< of a limit, for a value that keeps it after rounding

constexpr std::size_t most_accused = 20;  ///< particles that a verdict names

std::string others_likewise(std::size_t all) {
  return all > 1 ? fmt::format("; {} more likewise", all - 1) : std::string();
}

std::size_t slot_of(const Particles& particles, std::int64_t id) {
  return static_cast<std::size_t>(std::find(particles.id.begin(), particles.id.end(), id) - particles.id.begin());
}

}  // namespace

Monitor::Monitor(const Scene& scene, const Domain& domain, double dt, double recommended_dt, double energy_noise)
    : scene_(scene), domain_(domain), dt_(dt), recommended_dt_(recommended_dt), energy_noise_(energy_noise) {
  constexpr double farthest = std::numeric_limits<double>::max();
  const Vec3 side = domain.size();
  for (int axis = 0; axis < 3; ++axis) {
    const int low = 2 * axis, high = low + 1;
    const auto allowed = [&](int face) { return is_open(face) ? side[axis] : 0; };
    lowest_[axis] = domain.periodic[axis] || pulled_back(low) ? -farthest : domain.min[axis] - allowed(low);
    highest_[axis] = domain.periodic[axis] || pulled_back(high) ? farthest : domain.max[axis] + allowed(high);
  }
}

bool Monitor::is_open(int face) const {
  return std::count(scene_.domain.open.begin(), scene_.domain.open.end(), face) > 0;
}

bool Monitor::pulled_back(int face) const {
  const double outward = (face % 2 ? 1 : -1) * scene_.gravity.acceleration[face / 2];
  return is_open(face) && scene_.gravity.present && outward < 0;
}

double Monitor::beyond(int face, const Vec3& place) const {
  return face % 2 ? place[face / 2] - highest_[face / 2] : lowest_[face / 2] - place[face / 2];
}

NamedParticle Monitor::named(const Particles& particles, std::size_t slot) const {
  return {particles.id[slot], scene_.particles[particles.type[slot]].name};
}

void Monitor::accuse(RunVerdict& verdict, const Particles& particles, std::vector<std::size_t> slots,
                     const std::function<double(std::size_t slot)>& rank) const {
  std::sort(slots.begin(), slots.end(), [&](std::size_t a, std::size_t b) {
    return rank(a) != rank(b) ? rank(a) > rank(b) : particles.id[a] < particles.id[b];
  });
  slots.resize(std::min(slots.size(), most_accused));
  for (const std::size_t slot : slots) verdict.particles.push_back(named(particles, slot));
  const Vec3& p = particles.now.rows[slots.front()].position;
  if (p.allFinite()) verdict.place = domain_.wrapped(p);
}

std::string Monitor::step_advice() const {
  if (scene_.dynamics.overdamped()) {
    return dt_ > 0 ? fmt::format(
                         "dynamics.time_step is {:.3g} s, explicit Euler's limit in a bed is about {:.3g} s; take "
                         "\"auto\", or integrator = \"implicit\"",
                         dt_, recommended_dt_)
                   : fmt::format("dynamics.tolerance is {:g}; try a smaller one", *scene_.dynamics.tolerance);
  }
  if (!step_is_long()) return fmt::format("dynamics.time_step is {:.3g} us, as recommended; try half of it", dt_ * 1e6);
  return fmt::format("dynamics.time_step is {:.3g} us, recommended is {:.3g} us or less", dt_ * 1e6,
                     recommended_dt_ * 1e6);
}

void Monitor::advise_step(RunVerdict& verdict) const {
  verdict.advice += step_advice();
  if (!scene_.dynamics.overdamped()) {
    const double better = step_is_long() ? recommended_dt_ : 0.5 * dt_;
    verdict.remedies.push_back({"dynamics.time_step", fmt::format("{:.3g} s", better)});
  } else if (dt_ > 0) {
    verdict.remedies.push_back({"dynamics.time_step", "auto"});
    verdict.remedies.push_back({"dynamics.integrator", "implicit"});
  } else {
    constexpr double stricter = 0.1;
    verdict.remedies.push_back({"dynamics.tolerance", fmt::format("{:.3g}", stricter * *scene_.dynamics.tolerance)});
  }
}

void Monitor::check_positions(const Particles& particles, double time) const {
  const auto unsound = sum_in_blocks<std::size_t>(particles.slots(), 0, [&](std::size_t slot) {
    return particles.is_particle(slot) && !is_sound(particles.now.rows[slot]) ? 1 : 0;
  });
  if (unsound == 0) return;
  const auto is_number = [&](std::size_t slot) {
    const Row& row = particles.now.rows[slot];
    return row.position.allFinite() && row.velocity.allFinite();
  };
  const auto not_number = slots_where(particles, [&](std::size_t slot) { return !is_number(slot); });
  const auto fast = slots_where(particles, [&](std::size_t slot) {
    const Row& row = particles.now.rows[slot];
    return is_number(slot) && row.velocity.norm() * dt_ > longest_step * row.radius;
  });
  RunVerdict verdict = !not_number.empty() ? not_numbers(particles, not_number)
                       : !fast.empty()     ? too_fast(particles, fast)
                                           : lost(particles, slots_where(particles, [&](std::size_t slot) {
                                                return !is_sound(particles.now.rows[slot]);
                                              }));
  verdict.time = time;
  throw RunFailure(verdict);
}

RunVerdict Monitor::not_numbers(const Particles& particles, const std::vector<std::size_t>& slots) const {
  RunVerdict v{FailureKind::not_a_number};
  accuse(v, particles, slots, [](std::size_t) { return 0; });
  v.quantity = "position";
  v.value = std::numeric_limits<double>::quiet_NaN();
  v.unit = "m";
  v.what = fmt::format("the position or speed of {} is not a number{}", told(v.particles.front()),
                       others_likewise(slots.size()));
  v.cause = "centres at the same place, whose contact has no direction, or forces beyond what numbers hold";
  advise_step(v);
  return v;
}

RunVerdict Monitor::too_fast(const Particles& particles, const std::vector<std::size_t>& slots) const {
  RunVerdict v{FailureKind::particle_too_fast};
  const auto share = [&](std::size_t slot) {
    const Row& row = particles.now.rows[slot];
    return row.velocity.norm() * dt_ / row.radius;
  };
  accuse(v, particles, slots, share);
  const std::size_t first = slot_of(particles, v.particles.front().id);
  const double speed = particles.now.rows[first].velocity.norm();
  v.quantity = "way in one step over the radius";
  v.value = share(first);
  v.limit = longest_step;
  v.what = fmt::format(
      "{} at {} moves {:.3g} m in one step, more than {:g} of its radius, and could go through a boundary; its speed "
      "is {:.3g} m/s{}",
      told(v.particles.front()), told(*v.place), speed * dt_, longest_step, speed, others_likewise(slots.size()));
  if (step_is_long()) {
    v.cause = "the step is too large for the contacts, which throw particles out";
    advise_step(v);
  } else {
    const double slow_enough = safe_share * dt_ * longest_step / v.value;
    v.cause = "a deep overlap, a fast boundary, gravity or its own start has thrown it";
    v.advice = fmt::format("slow that down, or take dynamics.time_step = {:.3g} us or less", 1e6 * slow_enough);
    v.remedies.push_back({"dynamics.time_step", fmt::format("{:.3g} s", slow_enough)});
  }
  return v;
}

RunVerdict Monitor::lost(const Particles& particles, const std::vector<std::size_t>& slots) const {
  const auto worst_face = [&](std::size_t slot) {
    const Vec3& p = particles.now.rows[slot].position;
    int worst = 0;
    for (int face = 1; face < face_count; ++face) {
      if (beyond(face, p) > beyond(worst, p)) worst = face;
    }
    return worst;
  };
  RunVerdict v{FailureKind::particle_lost};
  accuse(v, particles, slots,
         [&](std::size_t slot) { return beyond(worst_face(slot), particles.now.rows[slot].position); });
  const std::size_t first = slot_of(particles, v.particles.front().id);
  const Vec3& p = particles.now.rows[first].position;
  const int face = worst_face(first), axis = face / 2;
  const bool open = is_open(face);
  v.limit = open ? domain_.size()[axis] : 0;
  v.quantity = fmt::format("way beyond the face {}", face_names[face]);
  v.value = beyond(face, p) + v.limit;
  v.unit = "m";
  v.what = fmt::format("{} left the domain through the face {} at {}{}", told(v.particles.front()), face_names[face],
                       told(p), others_likewise(slots.size()));
  if (open) {
    v.advice = "it is more than a domain's length away and nothing pulls it back; close the face with a boundary";
    v.remedies.push_back({"boundary"});
    return v;
  }
  v.advice = fmt::format(
      "add a boundary there, enlarge the domain, or list \"{}\" in domain.open; if it went through a boundary: ",
      face_names[face]);
  std::string faces;
  for (const int other : scene_.domain.open) faces += fmt::format("\"{}\", ", face_names[other]);
  v.remedies = {{"domain.open", fmt::format("[{}\"{}\"]", faces, face_names[face])}, {"boundary"}};
  advise_step(v);
  return v;
}

void Monitor::advise_on_overlap(RunVerdict& verdict, const std::vector<int>& materials, double time) const {
  if (scene_.filling.kind == FillingKind::file && time == 0) {
    verdict.advice = fmt::format("they overlap so in {}: move them apart there, or raise monitor.overlap_limit",
                                 *scene_.filling.path);
    verdict.remedies = {{"filling.path"}, {"monitor.overlap_limit"}};
    return;
  }
  const bool grows = time < scene_.filling.over();
  const char* stiffness = is_hertzian(scene_.contact.normal) ? "young_modulus" : "normal_stiffness";
  verdict.cause = grows            ? "radii grow too fast for contacts so soft"
                  : step_is_long() ? "the step is too large for such contacts, or they are too soft"
                                   : "the contact is too soft for what presses or strikes";
  verdict.advice =
      fmt::format("{}raise {}, or the step is too large: ", grows ? "lengthen filling.duration, " : "", stiffness);
  if (grows) verdict.remedies.push_back({"filling.duration"});
  for (const int material : materials)
    verdict.remedies.push_back({fmt::format("material[{}].{}", material, stiffness)});
  advise_step(verdict);
  if (!grows && step_is_long())
    std::rotate(verdict.remedies.begin(), verdict.remedies.end() - 1, verdict.remedies.end());
}

void Monitor::check_overlap(const StepSums& sums, const Particles& particles, double time) const {
  if (!sums.offence) return;
  const Offence& o = *sums.offence;
  RunVerdict v{FailureKind::overlap};
  v.time = time;
  const std::size_t first = slot_of(particles, o.first);
  const Row& row = particles.now.rows[first];
  v.particles.push_back(named(particles, first));
  v.place = domain_.wrapped(row.position);
  std::vector<int> materials = {particles.material[first]};
  double radius = row.radius;
  std::string other;
  double behind = -1;  // a boundary is the centre [m]
  if (o.second < 0) {
    const BoundarySpec& boundary = scene_.boundaries[-1 - o.second];
    v.boundaries.push_back(boundary.name);
    materials.push_back(boundary.material.empty() ? 0 : scene_.material_index(boundary.material));
    other = "boundary " + boundary.name;
    behind = o.overlap - growth_at(scene_, time).scale * radius;
  } else {
    const std::size_t second = slot_of(particles, o.second);
    v.particles.push_back(named(particles, second));
    materials.push_back(particles.material[second]);
    const Row& partner = particles.now.rows[second];
    const Vec3 apart = domain_.separation(partner.position, row.position);
    if (apart.norm() > 0) {  // the point of contact
      const double way = growth_at(scene_, time).scale * radius - 0.5 * o.overlap;
      v.place = domain_.wrapped(row.position + way / apart.norm() * apart);
    }
    radius = std::min(radius, partner.radius);
    other = told(v.particles.back());
  }
  const bool crossed = behind >= 0;
  if (materials.front() == materials.back()) materials.pop_back();
  v.value = o.overlap / radius;
  v.limit = crossed ? 1 : scene_.monitor.overlap_limit;
  v.quantity = o.second < 0 ? "overlap over the radius" : "overlap over the smaller radius";
  if (crossed) {
    v.kind = FailureKind::wall_crossed;
    v.what = fmt::format("{} went through {} at {}: its centre is {:.3g} m behind the surface",
                         told(v.particles.front()), other, told(*v.place), behind);
  } else {
    v.what =
        fmt::format("{} and {} overlap by {:.1f} % of the smaller radius at {}, beyond monitor.overlap_limit = {:g} %",
                    told(v.particles.front()), other, 100 * v.value, told(*v.place), 100 * v.limit);
  }
  advise_on_overlap(v, materials, time);
  throw RunFailure(v);
}

void Monitor::check_boundaries(const Boundaries& boundaries, double smallest_radius, double time) const {
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const Boundaries::Body& body = boundaries[k];
    const double most = longest_step * smallest_radius;
    if (!body.present || body.speed * dt_ <= most) continue;
    const double slow_enough = safe_share * most / body.speed;
    RunVerdict v{FailureKind::boundary_too_fast};
    v.time = time;
    v.boundaries.push_back(scene_.boundaries[k].name);
    v.place = body.pose(scene_.boundaries[k].point.value_or(Vec3::Zero()));
    v.quantity = "way in one step over the smallest radius";
    v.value = body.speed * dt_ / smallest_radius;
    v.limit = longest_step;
    v.what = fmt::format(
        "boundary {} moves {:.3g} m in one step, more than {:g} of the smallest radius, {:.3g} m, and could go through "
        "particles; its speed is {:.3g} m/s",
        scene_.boundaries[k].name, body.speed * dt_, longest_step, smallest_radius, body.speed);
    v.advice = fmt::format("slow it down, or take a time step of {:.3g} us or less", 1e6 * slow_enough);
    v.remedies = {{"dynamics.time_step", fmt::format("{:.3g} s", slow_enough)},
                  {fmt::format("boundary[{}].motion", k)}};
    throw RunFailure(v);
  }
}

}  // namespace packstone::engine
