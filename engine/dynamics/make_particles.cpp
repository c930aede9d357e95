#include "engine/dynamics/make_particles.hpp"

#include <numeric>

#include "core/geometry.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

namespace {

/// Whether the rows' velocities are ahead of the half step's, which then have arrays of their own.
bool leads(const Scene& scene) {
  return !scene.dynamics.overdamped() && scene.dynamics.contact_velocity != ContactVelocity::half_step;
}

void add(VectorArray& to, const Vec3& v) {
  to.x.push_back(v[0]);
  to.y.push_back(v[1]);
  to.z.push_back(v[2]);
}

}  // namespace

void append_particles(Particles& p, const Scene& scene, const StartingState& more) {
  for (std::size_t i = 0; i < more.size(); ++i) {
    const double radius = more.radius[i];
    const int material = scene.material_index(scene.particles[more.type[i]].material);
    const double mass = scene.materials[material].density * sphere_volume(radius);
    p.id.push_back(static_cast<std::int32_t>(p.count++));
    p.type.push_back(more.type[i]);
    p.material.push_back(material);
    p.mass.push_back(mass);
    p.now.rows.push_back({more.position[i], radius, more.velocity[i], 1 / mass});
    if (leads(scene)) add(p.half_velocity, more.velocity[i]);
    if (!rotates(scene)) continue;
    p.inverse_inertia.push_back(1 / sphere_inertia(mass, radius));
    p.now.spins.push_back({more.angular_velocity[i]});
    if (leads(scene)) add(p.half_angular_velocity, more.angular_velocity[i]);
  }
}

Particles make_particles(const Scene& scene, const StartingState& start) {
  Particles p;
  append_particles(p, scene, start);
  std::vector<std::int32_t> slots = p.id;
  slots.push_back(Particles::no_particle);
  p.reorder(slots);
  return p;
}

}  // namespace packstone::engine
