// A sphere that does not turn, a block, on a slope below the friction angle: laws with a spring hold it, laws without
// let it go.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "engine/static_friction.hpp"
#include "hand_made.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::contact_scene;
using engine::testing::HandMade;

namespace {

constexpr double slope = 10 * std::numbers::pi / 180, g = 9.8, damping = 50;
const double mass = 1200 * 4.0 / 3.0 * std::numbers::pi * std::pow(0.02, 3);

Scene slope_scene(const std::string& law) {
  return contact_scene("normal = \"linear\"\ntangential = \"" + law + "\"",
                       "restitution = 0.5\nfriction = 0.5\ntangential_stiffness = 1e6\ntangential_damping = 50\n"
                       "young_modulus = 1e8\npoisson_ratio = 0.3",
                       true);
}

/// Mean speed down the slope over a second, between the means of two windows of 0.2 s, from a time on [m/s].
double creep(const std::string& law, double dt, ContactVelocity velocity = ContactVelocity::step, double from = 0.2) {
  HandMade block(slope_scene(law), {{Vec3(0.3, 0.5, 0.02 - mass * g * std::cos(slope) / 1e6)}}, dt, velocity);
  block.input.gravity = g * Vec3(std::sin(slope), 0, -std::cos(slope));
  const auto mean_over = [&](double time) {
    double sum = 0;
    const long steps = std::lround(time / dt);
    for (long n = 0; n < steps; ++n) {
      block.step();
      block.set_spin(0, Vec3::Zero());
      sum += block.position(0).x() / static_cast<double>(steps);
    }
    return sum;
  };
  mean_over(from);
  const double before = mean_over(0.2);
  mean_over(0.8);
  return mean_over(0.2) - before;
}

}  // namespace

TEST_CASE("laws with a spring hold a block on a slope below the friction angle") {
  const std::string law = GENERATE("cundall-strack", "mindlin-deresiewicz", "walton-braun");
  INFO(law);
  // The block swings about where it is held; only mindlin-deresiewicz damps that, ever more slowly.
  const double swing = mass * g * std::sin(slope) / 8e3;  // of the softest, 8 um
  CHECK(std::abs(creep(law, 2e-5, ContactVelocity::half_step, 3)) < 1e-3 * swing);
}

TEST_CASE("viscous friction creeps at the load over its coefficient") {
  CHECK(creep("haff-werner", 2e-5) == Approx(mass * g * std::sin(slope) / damping).epsilon(1e-3));
  CHECK(creep("haff-werner", 1e-5) == Approx(creep("haff-werner", 2e-5)).epsilon(1e-3));
}

TEST_CASE("sliding friction chatters: the velocity turns round every few steps and grows with the step") {
  HandMade block(slope_scene("coulomb"), {{Vec3(0.3, 0.5, 0.02 - mass * g * std::cos(slope) / 1e6)}}, 2e-5);
  block.input.gravity = g * Vec3(std::sin(slope), 0, -std::cos(slope));
  int turns = 0;
  double largest = 0, before = 0;
  for (int n = 0; n < 10000; ++n) {
    block.step();
    block.set_spin(0, Vec3::Zero());
    const double v = block.velocity(0).x();
    turns += v * before < 0;
    before = v;
    if (n > 1000) largest = std::max(largest, std::abs(v));
  }
  CHECK(turns > 2000);
  CHECK(largest < 2 * g * 2e-5);  // of the order of what gravity gives in a step
  CHECK(largest > 0.1 * g * 2e-5);
  CHECK(std::abs(creep("coulomb", 2e-5)) < g * 2e-5);
}

TEST_CASE("a scene with gravity is warned of friction that cannot hold") {
  const auto warnings = [](const std::string& law, bool gravity) {
    Scene scene = slope_scene(law);
    scene.gravity.present = gravity;
    std::vector<std::string> list;
    warn_without_static_friction(scene, {{1, 0.02, 0.02}}, list);
    return list;
  };
  CHECK(warnings("cundall-strack", true).empty());
  CHECK(warnings("haff-werner", false).empty());
  REQUIRE(warnings("coulomb", true).size() == 1);
  REQUIRE(warnings("haff-werner", true).size() == 1);
  // 0.39 N over 50 N s/m.
  CHECK_THAT(warnings("haff-werner", true)[0], Catch::Matchers::Contains("7.9 mm/s"));
}
