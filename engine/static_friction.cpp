#include "engine/static_friction.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/geometry.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

namespace {

/// Speed at which a sphere creeps under its own weight, the largest over the groups [m/s].
double creep_speed(const Scene& scene, const Population& population) {
  double fastest = 0;
  for (std::size_t g = 0; g < population.size(); ++g) {
    const MaterialSpec& material = scene.materials[scene.material_index(scene.particles[g].material)];
    const double mass = material.density * sphere_volume(population[g].largest_radius);
    fastest = std::max(fastest, mass * scene.gravity.acceleration.norm() / *material.tangential_damping);
  }
  return fastest;
}

}  // namespace

void warn_without_static_friction(const Scene& scene, const Population& population,
                                  std::vector<std::string>& warnings) {
  if (!scene.gravity.present || !rotates(scene)) return;
  constexpr double millimetres = 1e3;
  if (scene.contact.tangential == TangentialModel::coulomb) {
    warnings.push_back(
        "contact.tangential: coulomb has no static friction, contacts at rest chatter from step to step; take "
        "cundall-strack where particles come to rest");
  }
  if (scene.contact.tangential == TangentialModel::haff_werner) {
    warnings.push_back(
        fmt::format("contact.tangential: haff-werner has no static friction, a contact creeps under load, under a "
                    "particle's own weight by up to {:.2g} mm/s; take cundall-strack where particles come to rest",
                    millimetres * creep_speed(scene, population)));
  }
}

}  // namespace packstone::engine
