#include "engine/contact_pairs.hpp"

#include <algorithm>

#include "core/geometry.hpp"

namespace packstone::engine {

std::vector<SmallestParticle> smallest_particles(const Scene& scene, const Population& population) {
  std::vector<SmallestParticle> particles;
  for (std::size_t g = 0; g < population.size(); ++g) {
    if (population[g].count == 0) continue;
    const MaterialSpec& material = scene.materials[scene.material_index(scene.particles[g].material)];
    const double radius = population[g].smallest_radius;
    particles.push_back({&scene.particles[g], &material, radius, material.density * sphere_volume(radius)});
  }
  return particles;
}

std::vector<ContactPair> contact_pairs(const Scene& scene, const Population& population) {
  const std::vector<SmallestParticle> particles = smallest_particles(scene, population);
  std::vector<ContactPair> pairs;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const SmallestParticle& a = particles[i];
    for (std::size_t j = i; j < particles.size(); ++j) {
      const SmallestParticle& b = particles[j];
      const PairSize<double> size{1 / a.mass + 1 / b.mass, a.radius * b.radius / (a.radius + b.radius)};
      pairs.push_back(
          {a.group->name + " - " + b.group->name, a.material, b.material, size, std::min(a.radius, b.radius)});
    }
    for (const BoundarySpec& wall : scene.boundaries) {
      const MaterialSpec& material = scene.materials[scene.material_index(wall.material)];
      pairs.push_back({a.group->name + " - " + wall.name, a.material, &material, {1 / a.mass, a.radius}, a.radius});
    }
  }
  return pairs;
}

}  // namespace packstone::engine
