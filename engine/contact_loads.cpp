#include "engine/contact_loads.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contact/contact_scales.hpp"
#include "engine/contact_pairs.hpp"

namespace packstone::engine {

namespace {

constexpr double bed_fraction = 0.6;        ///< of a loose bed, for its height
constexpr double overlap_of_slope = 0.005;  ///< of the radius, at which the slope of Hertz' force is taken

double gravity_of(const Scene& scene) { return scene.gravity.present ? scene.gravity.acceleration.norm() : 0; }

/// Overlap at which the elastic force holds a load, over the radius.
double overlap_under(const Scene& scene, const SmallestParticle& body, double load) {
  const PairSize<double> size{2 / body.mass, 0.5 * body.radius};
  const double at = overlap_of_slope * body.radius;
  const double slope = contact_scales(scene, *body.material, *body.material, size, at).stiffness;
  // Hertz' slope at an overlap is 3/2 F/xi there, and F goes as xi^(3/2).
  const bool hertzian = is_hertzian(scene.contact.normal);
  const double overlap = hertzian ? at * std::pow(load / (slope * at / 1.5), 2.0 / 3) : load / slope;
  return overlap / body.radius;
}

}  // namespace

double fall_height(const Scene& scene, const Vec3& size) {
  return size.cwiseProduct(scene.gravity.acceleration.cwiseAbs()).sum() / scene.gravity.acceleration.norm();
}

double fall_speed(const Scene& scene, const Vec3& size) {
  return gravity_of(scene) > 0 ? std::sqrt(2 * gravity_of(scene) * fall_height(scene, size)) : 0;
}

double resting_overlap(const Scene& scene, const Population& population, const Vec3& size, double solid_volume) {
  if (gravity_of(scene) == 0) return 0;
  const double area = size.prod() / fall_height(scene, size);
  const double bed_height = solid_volume / (bed_fraction * area);
  double share = 0;
  for (const SmallestParticle& body : smallest_particles(scene, population)) {
    const double column = std::max(1.0, bed_height / (2 * body.radius));
    share = std::max(share, overlap_under(scene, body, column * body.mass * gravity_of(scene)));
  }
  return share;
}

}  // namespace packstone::engine
