// Particles placed by hand and stepped without filling or files.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/dynamics/step.hpp"
#include "half_step.hpp"
#include "tests/sample_scene.hpp"

namespace packstone::engine::testing {

struct Sphere {
  Vec3 position;
  Vec3 velocity = Vec3::Zero();
  double radius = 0.02;
};

/// A scene of one material with the given contact table and further material keys, in a box of 1 m, maybe with a floor
/// and further tables.
inline Scene contact_scene(const std::string& contact, const std::string& material, bool floor = false,
                           const std::string& further = "") {
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
  return parse_scene(text + further, "hand-made");
}

class HandMade {
 public:
  HandMade(Scene scene, const std::vector<Sphere>& spheres, double dt,
           ContactVelocity contact_velocity = ContactVelocity::step) {
    scene.dynamics.contact_velocity = contact_velocity;
    StartingState start;
    for (const Sphere& s : spheres) {
      start.position.push_back(s.position);
      start.velocity.push_back(s.velocity);
      start.angular_velocity.push_back(Vec3::Zero());
      start.radius.push_back(s.radius);
      start.type.push_back(0);
    }
    particles = make_particles(scene, start);
    input.dt = dt;
    input.overlap_limit = 0.5;
    input.velocity_lead = contact_velocity == ContactVelocity::half_step ? 0 : 0.5 * dt;
    boundaries = std::make_unique<Boundaries>(scene, scene.box());
    dynamics = make_newtonian(scene, scene.box(), *boundaries);
  }

  StepSums step(Recorder* recorder = nullptr) {
    boundaries->go_to(time, input.dt, input.velocity_lead);
    if (dynamics->outdated(input.growth)) dynamics->rebuild(particles, input.growth, input.dt);
    const StepSums sums = dynamics->advance(particles, input, recorder);
    boundaries->push(dynamics->wall_loads(), input.gravity, time, input.dt);
    std::swap(particles.now, particles.next);
    time += input.dt;
    return sums;
  }

  std::size_t slot(std::int32_t id) const {
    return static_cast<std::size_t>(std::find(particles.id.begin(), particles.id.end(), id) - particles.id.begin());
  }
  Vec3 position(std::int32_t id) const { return particles.now.rows[slot(id)].position; }
  Vec3 velocity(std::int32_t id) const { return half_step_velocity(particles, slot(id)); }
  Vec3 angular_velocity(std::int32_t id) const { return half_step_turning(particles, slot(id)); }
  void set_spin(std::int32_t id, const Vec3& spin) {
    particles.now.spins[slot(id)].angular_velocity = spin;
    if (!particles.half_angular_velocity.empty()) particles.half_angular_velocity.set(slot(id), spin);
  }
  /// Puts a particle to rest somewhere.
  void hold(std::int32_t id, const Vec3& position) {
    Row& row = particles.now.rows[slot(id)];
    row.position = position;
    row.velocity.setZero();
    if (!particles.half_velocity.empty()) particles.half_velocity.set(slot(id), Vec3::Zero());
    set_spin(id, Vec3::Zero());
  }
  double mass(std::int32_t id) const { return particles.mass[slot(id)]; }
  double inertia(std::int32_t id) const { return 1 / particles.inverse_inertia[slot(id)]; }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < particles.slots(); ++i) sum += particles.mass[i] * half_step_velocity(particles, i);
    return sum;
  }

  Particles particles;
  StepInput input;
  double time = 0;
  std::unique_ptr<Boundaries> boundaries;
  std::unique_ptr<Dynamics> dynamics;
};

}  // namespace packstone::engine::testing
