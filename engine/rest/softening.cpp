#include "engine/rest/softening.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contact/head_on.hpp"
#include "engine/contact_loads.hpp"
#include "engine/contact_pairs.hpp"

namespace packstone::engine {

namespace {

constexpr double deepest_impact = 0.1;  ///< of the radius

void scale(std::optional<double>& value, double factor) {
  if (value) *value *= factor;
}

}  // namespace

Softening softening(const Scene& scene, const Population& population, double solid_volume) {
  const Vec3 size = scene.box().size();
  Softening way;
  way.resting_overlap = resting_overlap(scene, population, size, solid_volume);
  if (!scene.dynamics.overdamped()) {
    const double speed = fall_speed(scene, size);
    for (const ContactPair& pair : contact_pairs(scene, population)) {
      const Impact impact = impact_of(scene, *pair.a, *pair.b, pair.size, speed);
      way.impact_overlap = std::max(way.impact_overlap, impact.largest_overlap / pair.smaller_radius);
    }
  }
  // Overlaps under a load go as stiffness^-1, of Hertz' contacts ^(-2/3); in impacts as ^(-1/2) and ^(-2/5).
  const bool hertzian = is_hertzian(scene.contact.normal);
  const double load_power = hertzian ? 2.0 / 3 : 1.0, impact_power = hertzian ? 0.4 : 0.5;
  way.factor = std::min(1.0, std::max(std::pow(way.resting_overlap / *scene.dynamics.way_overlap, 1 / load_power),
                                      std::pow(way.impact_overlap / deepest_impact, 1 / impact_power)));
  way.resting_overlap *= std::pow(way.factor, -load_power);
  way.impact_overlap *= std::pow(way.factor, -impact_power);
  return way;
}

Scene softened(Scene scene, double factor) {
  // Dimensionless damping: c/sqrt(k m) of springs; c/(K^(2/5) m^(3/5) v^(1/5)) and B (K/m)^(2/5) v^(1/5) of Hertz'.
  const bool hertzian = is_hertzian(scene.contact.normal);
  const double dashpot = std::pow(factor, hertzian ? 0.4 : 0.5);
  for (MaterialSpec& m : scene.materials) {
    scale(m.normal_stiffness, factor);
    scale(m.tangential_stiffness, factor);
    scale(m.young_modulus, factor);
    if (scene.contact.normal != NormalModel::hysteretic) scale(m.normal_damping, dashpot);
    scale(m.dissipation_time, std::pow(factor, -0.4));
    scale(m.shear_viscosity, std::pow(factor, 0.6));  // B goes as viscosity over modulus
    scale(m.bulk_viscosity, std::pow(factor, 0.6));
  }
  return scene;
}

}  // namespace packstone::engine
