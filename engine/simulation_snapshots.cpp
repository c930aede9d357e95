// What a simulation shows of itself: its snapshots, and the state in which it has to be stopped.
#include <numeric>

#include <fmt/format.h>

#include "core/run_verdict.hpp"
#include "core/version.hpp"
#include "engine/failing_state.hpp"
#include "engine/filling/growth.hpp"
#include "engine/simulation.hpp"
#include "engine/snapshot_fields.hpp"

namespace packstone::engine {

Snapshot Simulation::geometry(std::int64_t number) const {
  Snapshot s;
  s.time = time_at(number);
  s.step = number;
  s.domain = domain_;
  if (scene_.gravity.present) s.gravity = scene_.gravity.acceleration;
  const double scale = growth_at(scene_, s.time).scale;
  s.position.resize(particles_.size());
  s.radius.resize(particles_.size());
  for (std::size_t slot = 0; slot < particles_.slots(); ++slot) {
    if (!particles_.is_particle(slot)) continue;
    const Row& row = particles_.now.rows[slot];
    s.position[particles_.id[slot]] = domain_.wrapped(row.position);
    s.radius[particles_.id[slot]] = scale * row.radius;
  }
  s.boundaries = boundaries_.records();
  return s;
}

Snapshot Simulation::described(std::int64_t number) const {
  Snapshot s = geometry(number);
  s.id.resize(particles_.size());
  std::iota(s.id.begin(), s.id.end(), std::int64_t{0});
  s.type.resize(particles_.size());
  s.material.resize(particles_.size());
  for (std::size_t slot = 0; slot < particles_.slots(); ++slot) {
    if (!particles_.is_particle(slot)) continue;
    s.type[particles_.id[slot]] = particles_.type[slot];
    s.material[particles_.id[slot]] = particles_.material[slot];
  }
  for (const auto& material : scene_.materials) s.material_names.push_back(material.name);
  for (const auto& group : scene_.particles) {
    s.groups.push_back({group.name, group.material, scene_.materials[scene_.material_index(group.material)].density});
  }
  s.scene_text = scene_text_;
  s.scene_hash = scene_hash_;
  s.program = fmt::format("packstone {} (git {})", version(), git_revision());
  return s;
}

Snapshot Simulation::snapshot(std::int64_t number, const Recorder& recorder) const {
  Snapshot s = described(number);
  const FieldSources sources{particles_, recorder, s, gravity_.acts(s.time)};
  for (const int field : scene_.output.fields) add_field(s.fields, static_cast<OutputField>(field), sources);
  if (scene_.output.contacts) {
    s.contacts = recorder.contacts;
    for (Vec3& point : s.contacts->point) point = domain_.wrapped(point);
  }
  return s;
}

void Simulation::fail(RunVerdict verdict, const SimulationEvents& events) const {
  verdict.step = steps_done_;
  if (!verdict.time) verdict.time = time_at(steps_done_);
  const FailingState state{scene_,  domain_, particles_, boundaries_, growth_at(scene_, time_at(steps_done_)).scale,
                           !scales_};
  state.name_contacts(verdict);
  if (events.failure) {
    Snapshot snapshot = described(steps_done_);
    state.mark(snapshot, verdict);
    events.failure(snapshot);
  }
  throw RunFailure(verdict);
}

}  // namespace packstone::engine
