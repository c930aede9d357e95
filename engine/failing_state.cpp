#include "engine/failing_state.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/slots_where.hpp"

namespace packstone::engine {

namespace {

std::vector<std::size_t> slots_of(const Particles& p, const std::vector<NamedParticle>& named) {
  std::vector<std::size_t> slots;
  for (const NamedParticle& one : named) {
    const auto found = std::find(p.id.begin(), p.id.end(), one.id);
    if (found != p.id.end()) slots.push_back(static_cast<std::size_t>(found - p.id.begin()));
  }
  return slots;
}

}  // namespace

NamedParticle FailingState::named(std::size_t slot) const {
  return {particles.id[slot], scene.particles[particles.type[slot]].name};
}

const Row* FailingState::other_instant(std::size_t slot) const {
  if (!two_instants || slot >= particles.next.rows.size()) return nullptr;
  const Row& row = particles.next.rows[slot];
  return row.radius > 0 && row.position.allFinite() ? &row : nullptr;
}

std::optional<Vec3> FailingState::place(std::size_t slot) const {
  const Vec3& now = particles.now.rows[slot].position;
  if (now.allFinite()) return now;
  const Row* other = other_instant(slot);
  return other ? std::optional(other->position) : std::nullopt;
}

bool FailingState::touch(std::size_t a, std::size_t b) const {
  const auto meet = [&](const Row& p, const Row& q) {
    return domain.separation(p.position, q.position).norm() < scale * (p.radius + q.radius);
  };
  if (meet(particles.now.rows[a], particles.now.rows[b])) return true;
  const Row *p = other_instant(a), *q = other_instant(b);
  return p && q && meet(*p, *q);
}

bool FailingState::touches(std::size_t slot, const Boundaries::Body& body) const {
  const auto at = place(slot);
  if (!at || !body.present) return false;
  const double radius = scale * particles.now.rows[slot].radius;
  bool any = false;
  boundaries.for_each_image(body, *at, [&](const Vec3& image, int /*shift*/) {
    const Vec3 inside = body.inside(image);
    if (body.shape.is_plane()) {
      any = any || body.shape.distance(0, inside) < radius;
    } else {
      body.shape.for_each_near(inside, radius, [&](std::int32_t /*piece*/) { any = true; });
    }
  });
  return any;
}

void FailingState::blame_same_place(RunVerdict& verdict, const std::vector<std::size_t>& offenders) const {
  constexpr double same_place = 1e-9;  // radii
  for (const std::size_t a : offenders) {
    const auto first = place(a);
    for (std::size_t b = 0; first && b < particles.slots(); ++b) {
      const auto second = b != a && particles.is_particle(b) ? place(b) : std::nullopt;
      if (!second || domain.separation(*first, *second).norm() > same_place * particles.now.rows[a].radius) continue;
      verdict.cause = fmt::format("its centre lay where that of particle {} does, and such a contact has no direction",
                                  particles.id[b]);
      verdict.advice = "move them apart where they come from";
      verdict.remedies = {{"filling"}};
      if (scene.filling.path) {
        verdict.advice = fmt::format("move them apart in {} (filling.path)", *scene.filling.path);
        verdict.remedies = {{"filling.path"}};
      }
      return;
    }
  }
}

void FailingState::name_next_no_numbers(RunVerdict& verdict) const {
  if (!two_instants || particles.next.rows.size() < particles.slots()) return;
  for (const std::size_t slot : slots_where(
           particles, [&](std::size_t candidate) { return !particles.next.rows[candidate].position.allFinite(); })) {
    verdict.particles.push_back(named(slot));
  }
  if (verdict.particles.empty()) return;
  verdict.what += fmt::format(", for that of {} is none", told(verdict.particles.front()));
}

void FailingState::name_contacts(RunVerdict& verdict) const {
  if (verdict.kind == FailureKind::not_a_number && verdict.particles.empty()) name_next_no_numbers(verdict);
  const std::vector<std::size_t> offenders = slots_of(particles, verdict.particles);
  if (offenders.empty()) return;
  if (const auto last = place(offenders.front()); last && !verdict.place) verdict.place = domain.wrapped(*last);
  if (verdict.kind == FailureKind::not_a_number) blame_same_place(verdict, offenders);
  const auto among_offenders = [&](std::size_t slot) {
    return std::find(offenders.begin(), offenders.end(), slot) != offenders.end();
  };
  for (const std::size_t slot : slots_where(particles, [&](std::size_t candidate) {
         return !among_offenders(candidate) &&
                std::any_of(offenders.begin(), offenders.end(), [&](std::size_t o) { return touch(o, candidate); });
       })) {
    verdict.touching.push_back(named(slot));
  }
  std::sort(verdict.touching.begin(), verdict.touching.end(),
            [](const NamedParticle& a, const NamedParticle& b) { return a.id < b.id; });
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const std::string& name = scene.boundaries[k].name;
    const bool named =
        std::find(verdict.boundaries.begin(), verdict.boundaries.end(), name) != verdict.boundaries.end();
    if (!named && std::any_of(offenders.begin(), offenders.end(),
                              [&](std::size_t slot) { return touches(slot, boundaries[k]); })) {
      verdict.boundaries.push_back(name);
    }
  }
}

void FailingState::mark(Snapshot& snapshot, const RunVerdict& verdict) const {
  snapshot.notes.push_back("the state in which the run was stopped: " + verdict.what);
  Field offender{1, "", std::vector<double>(snapshot.size(), 0.0)};
  for (const NamedParticle& p : verdict.touching) offender.values[static_cast<std::size_t>(p.id)] = 2;
  for (const NamedParticle& p : verdict.particles) offender.values[static_cast<std::size_t>(p.id)] = 1;
  snapshot.fields[offender_field] = std::move(offender);
  Field velocity{3, "m/s", std::vector<double>(3 * snapshot.size())};
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) {
    if (!particles.is_particle(slot)) continue;
    const Vec3& v = particles.now.rows[slot].velocity;
    std::copy(v.begin(), v.end(), velocity.values.begin() + 3 * static_cast<std::ptrdiff_t>(particles.id[slot]));
  }
  snapshot.fields["velocity"] = std::move(velocity);
  std::vector<bool> there(snapshot.size(), true);
  for (const std::size_t slot : slots_where(
           particles, [&](std::size_t candidate) { return !particles.now.rows[candidate].position.allFinite(); })) {
    const auto row = static_cast<std::size_t>(particles.id[slot]);
    const auto last = place(slot);
    if (last) snapshot.position[row] = domain.wrapped(*last);
    there[row] = last.has_value();
    snapshot.notes.push_back(fmt::format("the position of particle {} is not a number: it is {}", row,
                                         last ? "shown where it was a step before" : "left out"));
  }
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < there.size(); ++row) {
    if (there[row]) kept.push_back(row);
  }
  if (kept.size() < there.size()) snapshot = with_rows(snapshot, kept);
}

}  // namespace packstone::engine
