#include "engine/force_resolution.hpp"

#include <fmt/format.h>

#include "core/geometry.hpp"
#include "engine/contact/contact_scales.hpp"

namespace packstone::engine {

void warn_of_lost_weight(const Scene& scene, const Population& population, std::vector<std::string>& warnings) {
  constexpr double tolerable = 0.01;  // of the weight
  if (scene.dynamics.precision != Precision::mixed || !scene.gravity.present) return;
  const double largest = largest_radius(population);
  for (std::size_t g = 0; g < population.size(); ++g) {
    if (population[g].count == 0) continue;
    const MaterialSpec& material = scene.materials[scene.material_index(scene.particles[g].material)];
    const double radius = population[g].smallest_radius;
    const double mass = material.density * sphere_volume(radius);
    const double weight = mass * scene.gravity.acceleration.norm();
    const double rounding_of_overlap = single_resolution * 0.5 * (radius + largest);
    const PairSize<double> size{2 / mass, 0.5 * radius};
    const double stiffness =
        contact_scales(scene, material, material, size, scene.monitor.overlap_limit * radius).stiffness;
    const double rounding = stiffness * rounding_of_overlap;
    if (weight == 0 || rounding <= tolerable * weight) continue;
    warnings.push_back(fmt::format(
        "dynamics.precision: mixed rounds forces between particles by about {:.2g} N, {:.2g} of the weight of a sphere "
        "of \"{}\"; take double, or a stiffness of {:.2g} N/m or less, where that matters",
        rounding, rounding / weight, scene.particles[g].name, tolerable * weight / rounding_of_overlap));
  }
}

}  // namespace packstone::engine
