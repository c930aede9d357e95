// Attraction across gaps and in contact.
#include <cmath>

#include <catch2/catch.hpp>

#include "engine/contact/van_der_waals.hpp"
#include "hand_made.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::contact_scene;
using engine::testing::HandMade;
using engine::testing::Sphere;

namespace {

const std::string attraction = "[contact.van_der_waals]\nhamaker = 1e-9\nmin_gap = \"10 um\"\ncutoff = \"1 mm\"\n";
constexpr double hamaker = 1e-9, min_gap = 1e-5, cutoff = 1e-3;

double pull(double effective_radius, double gap) {
  const double h = std::max(gap, min_gap);
  return hamaker * effective_radius / (6 * h * h);
}

}  // namespace

TEST_CASE("van der Waals' force attracts as A R / 6 h^2, ends at the cut-off and stops growing at the smallest gap") {
  const double gap = GENERATE(-2e-6, 5e-6, 2e-5, 3e-4, 9.9e-4, 1.01e-3);
  const double second = GENERATE(0.02, 0.05);
  const Scene scene = contact_scene("normal = \"linear\"\n" + attraction, "restitution = 1");
  HandMade pair(scene, {{Vec3(0.4, 0.5, 0.5)}, {Vec3(0.4 + 0.02 + second + gap, 0.5, 0.5), Vec3::Zero(), second}},
                1e-9);
  pair.step();
  const double spring = gap < 0 ? 1e6 * -gap : 0;
  const double expected = gap < cutoff ? pull(0.02 * second / (0.02 + second), gap) - spring : 0;
  CHECK(pair.velocity(0).x() * pair.mass(0) / 1e-9 == Approx(expected).epsilon(1e-6).margin(1e-12));
  CHECK(pair.momentum().norm() < 1e-20);
}

TEST_CASE("the floor attracts as a sphere of infinite radius") {
  const Scene scene = contact_scene("normal = \"linear\"\n" + attraction, "restitution = 1", true);
  HandMade ball(scene, {{Vec3(0.5, 0.5, 0.02 + 5e-5)}}, 1e-9);
  ball.step();
  CHECK(-ball.velocity(0).z() * ball.mass(0) / 1e-9 == Approx(pull(0.02, 5e-5)).epsilon(1e-6));
}

TEST_CASE("the force is the slope of the potential, which is 0 at the cut-off") {
  VanDerWaalsSpec spec;
  spec.present = true;
  spec.hamaker = hamaker;
  spec.min_gap = min_gap;
  spec.cutoff = cutoff;
  const VanDerWaals law(spec);
  for (const double gap : {-3e-6, 4e-6, 2e-5, 5e-4}) {
    const double h = 1e-9;
    const double slope = (law.energy(0.01, gap + h) - law.energy(0.01, gap - h)) / (2 * h);
    CHECK(law.force(0.01, gap) == Approx(slope).epsilon(1e-6));
  }
  CHECK(law.energy(0.01, cutoff) == Approx(0).margin(1e-20));
}

TEST_CASE("two spheres that fall towards each other keep their energy, bounce and part again") {
  const Scene scene = contact_scene("normal = \"linear\"\n" + attraction, "restitution = 1");
  HandMade pair(scene, {{Vec3(0.4, 0.5, 0.5), Vec3(2e-3, 0, 0)}, {Vec3(0.4402, 0.5, 0.5), Vec3(-2e-3, 0, 0)}}, 2e-6);
  Recorder recorder;
  recorder.velocity.resize(2);
  recorder.force.resize(2);
  double first = 0, fastest = 0;
  bool touched = false;
  for (int n = 0; n < 200000; ++n) {
    const StepSums sums = pair.step(&recorder);
    const double energy = sums.kinetic_translational + sums.elastic + sums.attractive;
    if (n == 0) first = energy;
    CHECK(sums.attractive <= 0);
    REQUIRE(energy == Approx(first).margin(1e-3 * 0.5 * pair.mass(0) * fastest * fastest + 1e-12));
    fastest = std::max(fastest, pair.velocity(0).x());
    touched = touched || sums.particle_contacts > 0;
  }
  CHECK(touched);
  CHECK(fastest > 3e-3);  // they fell in
  // Beyond the cut-off they lack what the potential of the start was.
  const double potential = first - pair.mass(0) * 2e-3 * 2e-3;
  CHECK(pair.velocity(1).x() == Approx(std::sqrt(2e-3 * 2e-3 + potential / pair.mass(0))).epsilon(1e-4));
}

TEST_CASE("a slow sphere with damping sticks") {
  const Scene scene = contact_scene("normal = \"linear\"\n" + attraction, "restitution = 0.5");
  HandMade pair(scene, {{Vec3(0.4, 0.5, 0.5), Vec3(2e-3, 0, 0)}, {Vec3(0.4402, 0.5, 0.5)}}, 2e-6);
  for (int n = 0; n < 400000; ++n) pair.step();
  const double overlap = 0.04 - (pair.position(1) - pair.position(0)).norm();
  CHECK(overlap == Approx(pull(0.01, 0) / 1e6).epsilon(1e-3));  // where spring and attraction balance
}
