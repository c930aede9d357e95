#include "engine/dynamics/make_particles.hpp"

#include <numeric>

#include "core/geometry.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

Particles make_particles(const Scene& scene, const StartingState& start) {
  const std::size_t n = start.size();
  Particles p;
  p.count = n;
  p.now.rows.resize(n);
  const bool leads = scene.dynamics.contact_velocity != ContactVelocity::half_step;
  if (leads) p.half_velocity.resize(n);
  p.type = start.type;
  p.id.resize(n);
  std::iota(p.id.begin(), p.id.end(), 0);
  if (rotates(scene)) {
    p.now.spins.resize(n);
    if (leads) p.half_angular_velocity.resize(n);
    p.inverse_inertia.resize(n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = start.radius[i];
    const int material = scene.material_index(scene.particles[start.type[i]].material);
    const double mass = scene.materials[material].density * sphere_volume(radius);
    p.material.push_back(material);
    p.mass.push_back(mass);
    p.now.rows[i] = {start.position[i], radius, start.velocity[i], 1 / mass};
    if (leads) p.half_velocity.set(i, start.velocity[i]);
    if (!p.turns()) continue;
    p.inverse_inertia[i] = 1 / sphere_inertia(mass, radius);
    p.now.spins[i].angular_velocity = start.angular_velocity[i];
    if (leads) p.half_angular_velocity.set(i, start.angular_velocity[i]);
  }
  std::vector<std::int32_t> slots = p.id;
  slots.push_back(Particles::no_particle);
  p.reorder(slots);
  return p;
}

}  // namespace packstone::engine
