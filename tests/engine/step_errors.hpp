// What a finite step does to a collision, law by law: shared by the test that holds the laws to their order and by the
// chart of docs/physics.md.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "head_on.hpp"
#include "reference_collision.hpp"

namespace packstone::engine::testing {

/// A collision of two spheres of 20 mm and 1200 kg/m3 at 0.3 m/s, head on or aslant.
struct StepErrorCase {
  std::string name;
  std::string contact;   ///< the scene's [contact] table
  std::string material;  ///< further keys of its material
  double order;          ///< promised: errors fall as its power of the step
};

constexpr double step_error_speed = 0.3;  ///< of approach [m/s]

/// Root mean square of f over where within a step the contact begins, given as a share of the step.
template <class Function>
double over_first_touches(const Function& f) {
  constexpr int places = 16;
  double sum = 0;
  for (int place = 0; place < places; ++place) sum += std::pow(f((place + 0.5) / places), 2);
  return std::sqrt(sum / places);
}

/// Errors of the coefficient of restitution, against the scalar equation of motion.
class HeadOnErrors : public StepErrorCase {
 public:
  HeadOnErrors(StepErrorCase what, const ForceLaw& law)
      : StepErrorCase(std::move(what)),
        expected_(CollisionIntegrator(law, effective_mass(0.02), false).run(step_error_speed, 1e-4)) {}
  /// With a law that has memory, its closed form.
  HeadOnErrors(StepErrorCase what, const ReferenceCollision& expected)
      : StepErrorCase(std::move(what)), expected_(expected) {}

  double error(int steps_in_a_contact) const {
    const Scene scene = contact_scene(contact, material);
    const double dt = expected_.duration / steps_in_a_contact;
    return over_first_touches([&](double place) {
      return collide(scene, step_error_speed, 0.02, dt, place * step_error_speed * dt).restitution -
             expected_.restitution;
    });
  }

 private:
  ReferenceCollision expected_;
};

inline std::vector<HeadOnErrors> head_on_errors() {
  constexpr double young = 5e7, poisson = 0.3, k = 1e6;
  const std::string elastic = "young_modulus = 5e7\npoisson_ratio = 0.3\n";
  const double K = 4.0 / 3.0 * std::sqrt(0.01) * young / (2 * (1 - poisson * poisson));
  const double walton_braun_duration = 0.75 * std::numbers::pi * std::sqrt(effective_mass(0.02) / k);
  return {
      {{"linear, dashpot", "normal = \"linear\"", "normal_damping = 20", 2},
       [=](double xi, double rate) { return k * xi + 20 * rate; }},
      // Its dashpot begins and ends with a jump, beside which the elastic force is not yet there.
      {{"hertz, dashpot", "normal = \"hertz\"", elastic + "normal_damping = 8", 1},
       [=](double xi, double rate) { return K * std::pow(xi, 1.5) + 8 * rate; }},
      {{"kuwabara-kono", "normal = \"kuwabara-kono\"", elastic + "dissipation_time = 1e-4", 1.5},
       [=](double xi, double rate) { return K * (std::pow(xi, 1.5) + 1.5e-4 * std::sqrt(xi) * rate); }},
      {{"hysteretic", "normal = \"hysteretic\"", "normal_damping = 0.7", 2},
       [=](double xi, double rate) { return k * xi * (rate > 0 ? 1.7 : 0.3); }},
      {{"hysteretic, sign speed", "normal = \"hysteretic\"\nsign_speed = 0.3", "normal_damping = 0.7", 2},
       [=](double xi, double rate) { return k * xi * (1 + 0.7 * std::clamp(rate / 0.3, -1.0, 1.0)); }},
      {{"walton-braun", "normal = \"walton-braun\"", "unloading_stiffness = 4e6", 2},
       ReferenceCollision{0.5, walton_braun_duration, 0}},
  };
}

/// Errors of the velocities after an oblique impact, over the speed of approach, against the finest step: how
/// tangential laws converge; that they converge to what is right is tested elsewhere.
class ObliqueErrors : public StepErrorCase {
 public:
  static constexpr int finest = 40000;  ///< steps in a contact

  ObliqueErrors(StepErrorCase what, ContactVelocity contact_velocity)
      : StepErrorCase(std::move(what)),
        contact_velocity_(contact_velocity),
        expected_(departure(step_error_duration() / finest, 0.5)) {}

  double error(int steps_in_a_contact) const {
    const double dt = step_error_duration() / steps_in_a_contact;
    return over_first_touches(
        [&](double place) { return (departure(dt, place) - expected_).norm() / step_error_speed; });
  }

 private:
  /// Of the linear spring without damping [s].
  static double step_error_duration() { return std::numbers::pi * std::sqrt(effective_mass(0.02) / 1e6); }

  /// Of the second sphere, the surface turning with it [m/s].
  Vec3 departure(double dt, double place) const {
    constexpr double radius = 0.02;
    const Vec3 approach(step_error_speed, aslant * step_error_speed, 0);
    const double gap = place * step_error_speed * dt;
    // They touch where the second stands, whatever the gap.
    const Vec3 first(0.4, 0.5, 0.5), apart(2 * radius, 0, 0);
    HandMade pair(contact_scene(contact, material),
                  {{first - gap / step_error_speed * approach, approach}, {first + apart, Vec3::Zero()}}, dt,
                  contact_velocity_);
    Recorder recorder;
    recorder.velocity.resize(2);
    recorder.angular_velocity.resize(2);
    recorder.force.resize(2);
    bool touched = false;
    for (int n = 0; n < 10 * finest; ++n) {
      const bool touches = pair.step(&recorder).particle_contacts > 0;
      if (touched && !touches) break;
      touched = touches;
    }
    const Vec3 v = pair.velocity(1);
    return {v.x(), v.y(), radius * pair.angular_velocity(1).z()};
  }

  ContactVelocity contact_velocity_;
  Vec3 expected_;
  static constexpr double aslant = 0.7;  ///< tangential speed over normal speed: contacts stick and slide
};

inline std::vector<ObliqueErrors> oblique_errors() {
  const std::string law = "normal = \"linear\"\ntangential = ";
  const std::string rough = "normal_damping = 0\nfriction = 0.3\n";
  const std::string elastic = rough + "young_modulus = 5e7\npoisson_ratio = 0.3\n";
  std::vector<ObliqueErrors> result;
  // The velocities that contact_velocity = "auto" takes: springs want those half a step behind.
  const auto add = [&](const std::string& name, const std::string& material, double order, ContactVelocity velocity) {
    result.emplace_back(StepErrorCase{name, law + "\"" + name + "\"", material, order}, velocity);
  };
  add("coulomb", rough, 2, ContactVelocity::step);
  add("haff-werner", rough + "tangential_damping = 20", 2, ContactVelocity::step);
  add("cundall-strack", rough + "tangential_stiffness = 8e5", 2, ContactVelocity::half_step);
  add("mindlin-deresiewicz", elastic, 1, ContactVelocity::half_step);
  add("walton-braun", rough + "tangential_stiffness = 8e5", 1, ContactVelocity::half_step);
  return result;
}

}  // namespace packstone::engine::testing
