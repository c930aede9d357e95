#include "engine/force_resolution.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/geometry.hpp"
#include "engine/contact/contact_scales.hpp"

namespace packstone::engine {

namespace {

/// Of the smallest sphere of a group.
struct Rounding {
  double force;                ///< [N]
  double weight;               ///< [N]
  double stiffness_per_force;  ///< [1/m]
};

Rounding rounding_of(const Scene& scene, const Population& population, std::size_t group) {
  const MaterialSpec& material = scene.materials[scene.material_index(scene.particles[group].material)];
  const double radius = population[group].smallest_radius;
  const double mass = material.density * sphere_volume(radius);
  const double rounding_of_overlap = single_resolution * 0.5 * (radius + largest_radius(population));
  const PairSize<double> size{2 / mass, 0.5 * radius};
  const double stiffness =
      contact_scales(scene, material, material, size, scene.monitor.overlap_limit * radius).stiffness;
  return {stiffness * rounding_of_overlap, mass * scene.gravity.acceleration.norm(), 1 / rounding_of_overlap};
}

}  // namespace

double rounding_over_weight(const Scene& scene, const Population& population) {
  double worst = 0;
  for (std::size_t g = 0; g < population.size(); ++g) {
    if (population[g].count == 0) continue;
    const Rounding rounding = rounding_of(scene, population, g);
    worst = std::max(worst, rounding.force / rounding.weight);
  }
  return worst;
}

void warn_of_lost_weight(const Scene& scene, const Population& population, std::vector<std::string>& warnings) {
  constexpr double tolerable = 0.01;  // of the weight
  if (scene.dynamics.precision != Precision::mixed || !scene.gravity.present) return;
  for (std::size_t g = 0; g < population.size(); ++g) {
    if (population[g].count == 0) continue;
    const Rounding r = rounding_of(scene, population, g);
    if (r.weight == 0 || r.force <= tolerable * r.weight) continue;
    warnings.push_back(fmt::format(
        "dynamics.precision: mixed rounds forces between particles by about {:.2g} N, {:.2g} of the weight of a sphere "
        "of \"{}\"; take double, or a stiffness of {:.2g} N/m or less, where that matters",
        r.force, r.force / r.weight, scene.particles[g].name, tolerable * r.weight * r.stiffness_per_force));
  }
}

}  // namespace packstone::engine
