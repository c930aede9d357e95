#include "engine/snapshot_fields.hpp"

#include "core/geometry.hpp"

namespace packstone::engine {

namespace {

/// One value a particle by id, from its slot.
template <class Value>
std::vector<double> by_id(const Particles& p, const Value& value) {
  std::vector<double> values(p.size());
  for (std::size_t slot = 0; slot < p.slots(); ++slot) {
    if (p.is_particle(slot)) values[static_cast<std::size_t>(p.id[slot])] = value(slot);
  }
  return values;
}

/// Rows of three; zeros where nothing turns.
Field vectors(const std::vector<Vec3>& rows, std::size_t particles, const char* unit) {
  Field field{3, unit, {}};
  field.values.reserve(3 * particles);
  for (const Vec3& v : rows) field.values.insert(field.values.end(), {v[0], v[1], v[2]});
  field.values.resize(3 * particles, 0.0);
  return field;
}

double inertia(const Particles& p, std::size_t slot) { return sphere_inertia(p.mass[slot], p.now.rows[slot].radius); }

}  // namespace

void add_field(std::map<std::string, Field>& fields, OutputField which, const FieldSources& from) {
  const Particles& p = from.particles;
  const Recorder& r = from.recorder;
  const auto scalar = [&](const char* name, const char* unit, const auto& value) {
    fields[name] = {1, unit, by_id(p, value)};
  };
  const auto id = [&](std::size_t slot) { return static_cast<std::size_t>(p.id[slot]); };
  switch (which) {
    case output_velocity:
      fields["velocity"] = vectors(r.velocity, p.size(), "m/s");
      return;
    case output_angular_velocity:
      fields["angular_velocity"] = vectors(r.angular_velocity, p.size(), "rad/s");
      return;
    case output_force:
      fields["force"] = vectors(r.force, p.size(), "N");
      return;
    case output_acceleration: {
      std::vector<Vec3> rows(p.size());
      for (std::size_t slot = 0; slot < p.slots(); ++slot) {
        if (p.is_particle(slot)) rows[id(slot)] = r.force[id(slot)] / p.mass[slot];
      }
      fields["acceleration"] = vectors(rows, p.size(), "m/s2");
      return;
    }
    case output_angular_acceleration:
      fields["angular_acceleration"] = vectors(r.angular_acceleration, p.size(), "rad/s2");
      return;
    case output_mass:
      scalar("mass", "kg", [&](std::size_t slot) { return p.mass[slot]; });
      return;
    case output_full_radius:
      scalar("full_radius", "m", [&](std::size_t slot) { return p.now.rows[slot].radius; });
      return;
    case output_moment_of_inertia:
      scalar("moment_of_inertia", "kg m2", [&](std::size_t slot) { return inertia(p, slot); });
      return;
    case output_kinetic_translational:
      scalar("kinetic_translational", "J",
             [&](std::size_t slot) { return 0.5 * p.mass[slot] * r.velocity[id(slot)].squaredNorm(); });
      return;
    case output_kinetic_rotational:
      scalar("kinetic_rotational", "J", [&](std::size_t slot) {
        return r.angular_velocity.empty() ? 0.0 : 0.5 * inertia(p, slot) * r.angular_velocity[id(slot)].squaredNorm();
      });
      return;
    case output_elastic:
      fields["elastic"] = {1, "J", r.elastic};
      return;
    case output_gravitational:
      fields["gravitational"] = {1, "J",
                                 gravitational_energies(p, from.geometry, bed_frame(from.geometry), from.gravity_acts)};
      return;
  }
}

std::vector<double> gravitational_energies(const Particles& p, const Snapshot& geometry, const BedFrame& frame,
                                           bool gravity_acts) {
  Vec3 zero_level = geometry.domain.min;
  zero_level[frame.axis] = frame.floor;
  return by_id(p, [&](std::size_t slot) {
    const Vec3 height = geometry.position[static_cast<std::size_t>(p.id[slot])] - zero_level;
    return gravity_acts ? -p.mass[slot] * geometry.gravity.dot(height) : 0.0;
  });
}

}  // namespace packstone::engine
