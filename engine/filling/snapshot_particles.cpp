// An earlier run's snapshot as a start.

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/snapshot.hpp"
#include "engine/filling/particle_readers.hpp"

namespace packstone::engine {

namespace {

/// A vector field's value in a row; zero where the snapshot does not have the field.
Vec3 vector_at(const Snapshot& s, const std::string& path, const std::string& name, std::size_t row) {
  const auto found = s.fields.find(name);
  if (found == s.fields.end()) return Vec3::Zero();
  if (found->second.components != 3) throw InputError(fmt::format("{}: {} has no three components", path, name));
  const double* first = &found->second.values[3 * row];
  const Vec3 value(first[0], first[1], first[2]);
  if (!value.allFinite()) throw InputError(fmt::format("{}: particle {}: {}: is not finite", path, s.id[row], name));
  return value;
}

}  // namespace

std::vector<FileParticle> read_snapshot_particles(const std::string& path) {
  const Snapshot s = read_snapshot(path, {.region = std::nullopt, .contacts = false});
  std::vector<FileParticle> particles;
  for (std::size_t i = 0; i < s.size(); ++i) {
    particles.push_back({.id = s.id[i],
                         .line = 0,
                         .position = s.position[i],
                         .velocity = vector_at(s, path, "velocity", i),
                         .angular_velocity = vector_at(s, path, "angular_velocity", i),
                         .radius = s.radius[i],
                         .group = s.type[i]});
  }
  return particles;
}

}  // namespace packstone::engine
