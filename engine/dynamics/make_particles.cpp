#include "engine/dynamics/make_particles.hpp"

#include "core/geometry.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

namespace {

constexpr double solid_sphere_inertia = 2.0 / 5.0;  ///< in m R^2

}  // namespace

Particles make_particles(const Scene& scene, const StartingState& start) {
  const std::size_t n = start.size();
  const bool turning = rotates(scene);
  Particles p;
  p.now.resize(n, turning);
  p.next.resize(n, turning);
  p.half_velocity.resize(n);
  if (turning) p.half_angular_velocity.resize(n);
  p.radius = start.radius;
  p.type = start.type;
  for (std::size_t i = 0; i < n; ++i) {
    const int material = scene.material_index(scene.particles[start.type[i]].material);
    const double mass = scene.materials[material].density * sphere_volume(start.radius[i]);
    p.material.push_back(static_cast<std::uint16_t>(material));
    p.inverse_mass.push_back(1 / mass);
    p.inverse_inertia.push_back(1 / (solid_sphere_inertia * mass * start.radius[i] * start.radius[i]));
    p.now.position.set(i, start.position[i]);
    p.now.velocity.set(i, start.velocity[i]);
    p.half_velocity.set(i, start.velocity[i]);
    if (!turning) continue;
    p.now.angular_velocity.set(i, start.angular_velocity[i]);
    p.half_angular_velocity.set(i, start.angular_velocity[i]);
  }
  return p;
}

}  // namespace packstone::engine
