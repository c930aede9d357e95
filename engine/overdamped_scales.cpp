#include "engine/overdamped_scales.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/geometry.hpp"
#include "engine/contact/contact_scales.hpp"
#include "engine/dynamics/overdamped_system.hpp"

namespace packstone::engine {

namespace {

/// Largest rate of a bed's motion over that of two spheres in contact by themselves, 2 k/mu: measured,
/// docs/overdamped.md.
constexpr double bed_over_pair = 5;

struct Body {
  const MaterialSpec* material;
  double mass, radius, mobility;
  std::string name;
};

std::vector<Body> smallest_bodies(const Scene& scene, const Population& population) {
  std::vector<Body> bodies;
  for (std::size_t g = 0; g < population.size(); ++g) {
    if (population[g].count == 0) continue;
    const MaterialSpec& material = scene.materials[scene.material_index(scene.particles[g].material)];
    const double radius = population[g].smallest_radius;
    bodies.push_back({&material, material.density * sphere_volume(radius), radius, 1 / resistance(scene, g, radius),
                      scene.particles[g].name});
  }
  return bodies;
}

double stiffness(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b, const PairSize<double>& size,
                 double smaller_radius) {
  return contact_scales(scene, a, b, size, scene.monitor.overlap_limit * smaller_radius).stiffness;
}

}  // namespace

OverdampedScales overdamped_scales(const Scene& scene, const Population& population) {
  OverdampedScales scales;
  double fastest = 0;
  const double gravity = scene.gravity.present ? scene.gravity.acceleration.norm() : 0;
  const auto consider = [&](const Body& a, double k, double mobility, const std::string& pair) {
    if (k * mobility <= fastest) return;
    fastest = k * mobility;
    scales.contact_time = 1 / (k * a.mobility);
    scales.stiffness = k;
    scales.stiffness_ratio = gravity > 0 ? k * a.radius / (a.mass * gravity) : 0;
    scales.radius = a.radius;
    scales.sinking_speed = a.mass * gravity * a.mobility;
    scales.single_limit = 2 / fastest;
    scales.bed_limit = scales.single_limit / bed_over_pair;
    scales.pair = pair;
  };
  const std::vector<Body> bodies = smallest_bodies(scene, population);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& a = bodies[i];
    for (std::size_t j = i; j < bodies.size(); ++j) {
      const Body& b = bodies[j];
      const PairSize<double> size{1 / a.mass + 1 / b.mass, a.radius * b.radius / (a.radius + b.radius)};
      const double k = stiffness(scene, *a.material, *b.material, size, std::min(a.radius, b.radius));
      consider(a.mobility > b.mobility ? a : b, k, a.mobility + b.mobility, a.name + " - " + b.name);
    }
    for (const BoundarySpec& wall : scene.boundaries) {
      const MaterialSpec& material = scene.materials[scene.material_index(wall.material)];
      const double k = stiffness(scene, *a.material, material, {1 / a.mass, a.radius}, a.radius);
      consider(a, k, a.mobility, a.name + " - " + wall.name);
    }
  }
  return scales;
}

Integrator chosen_integrator(const Scene& scene) {
  // The quickest in every bed measured, soft or stiff (docs/overdamped.md).
  const Integrator asked = scene.dynamics.integrator;
  return asked == Integrator::automatic ? Integrator::rkc : asked;
}

const char* name_of(Integrator integrator) {
  switch (integrator) {
    case Integrator::euler:
      return "euler";
    case Integrator::rkc:
      return "rkc";
    case Integrator::implicit:
      return "implicit";
    case Integrator::automatic:
      break;
  }
  return "auto";
}

StepLimit overdamped_step_limit(const OverdampedScales& scales) {
  StepLimit limit;
  limit.limit = scales.single_limit;
  limit.recommended = scales.bed_limit;
  limit.contact_time = scales.contact_time;
  limit.pair = scales.pair;
  return limit;
}

void check_overdamped_step(const Scene& scene, const OverdampedScales& scales, std::vector<std::string>& warnings) {
  if (!scene.dynamics.time_step || scene.dynamics.integrator != Integrator::euler) return;
  const double dt = *scene.dynamics.time_step;
  const std::string what = fmt::format("{:.3g} s is beyond explicit Euler's limit, {:.3g} s, of ", dt,
                                       dt > scales.single_limit ? scales.single_limit : scales.bed_limit);
  if (dt > scales.single_limit) {
    scene.fail(
        "dynamics.time_step",
        what + fmt::format("the contact {} by itself (t_0 = mu/k = {:.3g} s); take at most {:.3g} s, \"auto\", or "
                           "integrator = \"implicit\"",
                           scales.pair, scales.contact_time, scales.bed_limit));
  }
  if (dt > scales.bed_limit) {
    warnings.push_back("dynamics.time_step: " + what + "spheres with as many contacts as in a bed; \"auto\" finds it");
  }
}

double look_interval(const Scene& scene) {
  const double snapshots = scene.output.interval;
  constexpr double rounding = 1e-9;
  return snapshots / std::max(1.0, std::ceil(snapshots / scene.output.history_interval * (1 - rounding)));
}

}  // namespace packstone::engine
