// Particles placed by hand and stepped without filling or files.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/dynamics/step.hpp"
#include "tests/sample_scene.hpp"

namespace packstone::engine::testing {

struct Sphere {
  Vec3 position;
  Vec3 velocity = Vec3::Zero();
  double radius = 0.02;
  double density = 1200;
  std::size_t material = 0;
};

/// A scene of one material with the given contact table and further material keys, in a box of 1 m with a floor.
inline Scene contact_scene(const std::string& contact, const std::string& material, bool floor = false) {
  std::string text = R"(
[dynamics]
duration = 1
[domain]
min = [0, 0, 0]
max = [1, 1, 1]
[contact]
)" + contact + R"(
[[material]]
name = "m"
density = 1200
normal_stiffness = 1e6
)" + material + R"(
[[particles]]
material = "m"
count = 1
radius = 0.02
[filling]
kind = "growth"
duration = 0.1
[output]
interval = 0.1
)";
  if (floor) text += "[[boundary]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  return parse_scene(text, "hand-made");
}

class HandMade {
 public:
  HandMade(const Scene& scene, const std::vector<Sphere>& spheres, double dt) : scene_(scene) {
    const bool turning = rotates(scene);
    particles.now.resize(spheres.size(), turning);
    particles.next.resize(spheres.size(), turning);
    particles.half_velocity.resize(spheres.size());
    if (turning) particles.half_angular_velocity.resize(spheres.size());
    double largest_radius = 0.02;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const Sphere& s = spheres[i];
      largest_radius = std::max(largest_radius, s.radius);
      const double mass = s.density * 4.0 / 3.0 * std::numbers::pi * std::pow(s.radius, 3);
      particles.radius.push_back(s.radius);
      particles.inverse_mass.push_back(1 / mass);
      particles.inverse_inertia.push_back(1 / (0.4 * mass * s.radius * s.radius));
      particles.material.push_back(static_cast<std::uint16_t>(s.material));
      particles.type.push_back(0);
      particles.now.position.set(i, s.position);
      particles.now.velocity.set(i, s.velocity);
      particles.half_velocity.set(i, s.velocity);
    }
    input.dt = dt;
    input.overlap_limit = 0.5;
    dynamics = make_newtonian(scene_, scene_.box(), make_planes(scene_), largest_radius);
  }

  StepSums step(Recorder* recorder = nullptr) {
    if (dynamics->neighbours().builds() == 0 ||
        dynamics->neighbours().outdated(last.largest_displacement_squared, input.growth)) {
      dynamics->rebuild(particles, input.growth);
    }
    last = dynamics->advance(particles, input, recorder);
    std::swap(particles.now, particles.next);
    return last;
  }

  Vec3 velocity(std::size_t i) const { return particles.half_velocity.get(i); }
  double mass(std::size_t i) const { return 1 / particles.inverse_mass[i]; }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < particles.size(); ++i) sum += mass(i) * velocity(i);
    return sum;
  }

  Particles particles;
  StepInput input;
  StepSums last;
  std::unique_ptr<Dynamics> dynamics;

 private:
  Scene scene_;
};

}  // namespace packstone::engine::testing
