// Head-on collisions against the closed forms of Zhong et al. (2009), eqs [7]-[9], model V, and of Schwager & Poeschel
// (2007).
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "engine/contact/collision.hpp"
#include "head_on.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::collide;
using engine::testing::contact_scene;
using engine::testing::effective_mass;
using engine::testing::HandMade;
using engine::testing::HeadOn;

TEST_CASE("a linear collision has eq. [7]'s restitution, [8]'s duration and keeps to [9]'s overlap") {
  const double damping = GENERATE(0.0, 5.0, 20.0);
  const double radius = GENERATE(0.02, 0.05);
  const Scene scene = contact_scene("normal = \"linear\"", "normal_damping = " + std::to_string(damping));
  const double m = effective_mass(radius), rate = damping / (2 * m);
  const double duration = std::numbers::pi / std::sqrt(1e6 / m - rate * rate);
  const HeadOn o = collide(scene, 0.5, radius, duration / 20000);
  CHECK(o.restitution == Approx(std::exp(-rate * duration)).epsilon(2e-4));
  CHECK(o.contact_time == Approx(duration).epsilon(2e-4));
  CHECK(o.largest_overlap <= 0.5 * duration / std::numbers::pi * (1 + 1e-6));
  if (damping == 0) CHECK(o.largest_overlap == Approx(0.5 * duration / std::numbers::pi).epsilon(1e-5));
  CHECK(o.momentum_change < 1e-11);
}

TEST_CASE("a linear collision that ends with its force has Schwager and Poeschel's restitution") {
  const double zeta = GENERATE(0.05, 0.3, 0.6, 0.9);
  const double m = effective_mass(0.02), omega0 = std::sqrt(1e6 / m);
  const double beta = zeta * omega0, omega = std::sqrt(omega0 * omega0 - beta * beta);
  // Their eq. for beta < omega0/sqrt(2), and the one above it.
  const double angle = beta < omega0 / std::sqrt(2.0)
                           ? std::numbers::pi - std::atan(2 * beta * omega / (omega * omega - beta * beta))
                           : std::atan(-2 * beta * omega / (omega * omega - beta * beta));
  const double expected = std::exp(-beta / omega * angle);
  CHECK(linear_restitution(zeta, Release::zero_force) == Approx(expected).epsilon(1e-12));
  const Scene scene = contact_scene("normal = \"linear\"\nrelease = \"zero-force\"",
                                    "normal_damping = " + std::to_string(2 * zeta * std::sqrt(1e6 * m)));
  CHECK(collide(scene, 0.5, 0.02, 1e-8).restitution == Approx(expected).epsilon(1e-3));
}

TEST_CASE("a given restitution comes out for equal and unequal masses") {
  const double e = GENERATE(0.3, 0.42, 0.9, 1.0);
  const double radius = GENERATE(0.02, 0.06);
  const std::string contact =
      GENERATE("normal = \"linear\"", "normal = \"linear\"\nrelease = \"zero-force\"", "normal = \"hysteretic\"");
  const Scene scene = contact_scene(contact, "restitution = " + std::to_string(e));
  CHECK(collide(scene, 1.0, radius, 2e-8).restitution == Approx(e).epsilon(1e-3));
}

TEST_CASE("hysteretic restitution is sqrt((1-g)/(1+g)) at any speed and mass") {
  const double g = GENERATE(0.0, 0.3, 0.7, 0.95);
  const double speed = GENERATE(0.01, 1.0);
  const double radius = GENERATE(0.02, 0.05);
  const Scene scene = contact_scene("normal = \"hysteretic\"", "normal_damping = " + std::to_string(g));
  const HeadOn o = collide(scene, speed, radius, 2e-8);
  CHECK(o.restitution == Approx(std::sqrt((1 - g) / (1 + g))).epsilon(1e-3));
  CHECK(o.restitution <= 1 + 1e-7);
  CHECK(o.momentum_change < 1e-11);
  // Loading on k(1+g), unloading on k(1-g), a quarter period each.
  const double root = std::sqrt(effective_mass(radius) / 1e6);
  const double duration = 0.5 * std::numbers::pi * root * (1 / std::sqrt(1 + g) + 1 / std::sqrt(1 - g));
  CHECK(o.contact_time == Approx(duration).epsilon(1e-3));
}

TEST_CASE("a sphere rebounds from a wall as from a body of infinite mass") {
  const Scene scene = contact_scene("normal = \"linear\"", "restitution = 0.6", true);
  HandMade ball(scene, {{Vec3(0.5, 0.5, 0.0201), Vec3(0.1, 0, -1)}}, 1e-7);
  for (int n = 0; n < 20000; ++n) ball.step();
  CHECK(ball.velocity(0).z() == Approx(0.6).epsilon(1e-3));
  CHECK(ball.velocity(0).x() == 0.1);
}

TEST_CASE("the leapfrog scheme is of second order in an undamped collision") {
  const Scene scene = contact_scene("normal = \"linear\"", "normal_damping = 0", true);
  const double duration = undamped_contact_time(1e6, 1200 * 4.0 / 3.0 * std::numbers::pi * std::pow(0.02, 3));
  // Position within the contact, from the exact entry into it.
  const auto error = [&](int steps) {
    const double dt = 0.4 * duration / steps;
    HandMade ball(scene, {{Vec3(0.5, 0.5, 0.02), Vec3(0, 0, -0.5)}}, dt);
    for (int n = 0; n < steps; ++n) ball.step();
    const double omega = std::numbers::pi / duration;
    return std::abs(ball.position(0).z() - (0.02 - 0.5 / omega * std::sin(omega * 0.4 * duration)));
  };
  const double order = std::log2(error(50) / error(100));
  CHECK(order == Approx(2).margin(0.1));
}
