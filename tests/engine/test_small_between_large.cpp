// A small sphere on top of the groove between two large ones: it rolls down the groove and falls off. Schemes that add
// up friction's displacement in a plane half a step off make it stick above a ratio of radii of about 3 (Vyas, Ottino,
// Lueptow & Umbanhowar, Comput. Phys. Commun. 310 (2025) 109524; the numbers are those of LAMMPS' example of it).
#include <cmath>

#include <catch2/catch.hpp>

#include "hand_made.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::HandMade;
using engine::testing::Sphere;

namespace {

constexpr double large = 5e-3, gravity = 9.81, start_angle = 1 * M_PI / 180;

Scene groove_scene() {
  return parse_scene(R"(
[dynamics]
duration = 1
[domain]
min = [-0.03, -0.02, -0.02]
max = [0.03, 0.02, 0.02]
[contact]
normal = "linear"
tangential = "cundall-strack"
[[material]]
name = "m"
density = 2500
normal_stiffness = 1e4
tangential_stiffness = 8235
restitution = 0.5
friction = 0.5
[[particles]]
material = "m"
count = 1
radius = 0.005
[filling]
kind = "growth"
duration = 0.1
[output]
interval = 0.1
)",
                     "groove");
}

/// How the centre goes round the groove's axis: (1 + 2/5 (r_small/rho)^2) r angle'' = g sin(angle), rho the distance of
/// the centre from the line through both points of contact, as long as it rolls.
double rolling_time(double small, double to_angle) {
  const double r = std::sqrt((large + small) * (large + small) - large * large);
  const double rho = small * r / (large + small);
  const double rate = gravity / (r * (1 + 0.4 * small * small / (rho * rho)));
  // Energy gives the angular velocity; the time is its integral, by the midpoint rule in log(angle) from the start.
  constexpr int parts = 200000;
  double time = 0;
  const double span = std::acosh(to_angle / start_angle);  // angle = start cosh(u): no singularity at rest
  for (int k = 0; k < parts; ++k) {
    const double u = span * (k + 0.5) / parts, angle = start_angle * std::cosh(u);
    time += span / parts * start_angle * std::sinh(u) / std::sqrt(2 * rate * (std::cos(start_angle) - std::cos(angle)));
  }
  return time;
}

}  // namespace

TEST_CASE("a small sphere rolls out of the groove between two large ones, at any ratio of radii") {
  const double ratio = GENERATE(1.0, 3.0, 10.0, 20.0, 100.0);
  const double small = large / ratio, r = std::sqrt((large + small) * (large + small) - large * large);
  const double stiffest = std::sqrt(2500 * 4.0 / 3.0 * M_PI * std::pow(small, 3) / 1e4);
  const double dt = (ratio > 50 ? 0.2 : 0.05) * stiffest;
  HandMade groove(groove_scene(),
                  {{Vec3(0, r * std::sin(start_angle), r * std::cos(start_angle)), Vec3::Zero(), small},
                   {Vec3(-large, 0, 0), Vec3::Zero(), large},
                   {Vec3(large, 0, 0), Vec3::Zero(), large}},
                  dt, ContactVelocity::half_step);  // what "auto" takes for these laws
  groove.input.gravity = Vec3(0, 0, -gravity);
  const auto hold_large = [&] {
    for (const int id : {1, 2}) groove.hold(id, Vec3(id == 1 ? -large : large, 0, 0));
  };
  const auto angle = [&] { return std::atan2(groove.position(0).y(), groove.position(0).z()); };
  const double to_angle = 20 * M_PI / 180, expected = rolling_time(small, to_angle);
  double time = 0;
  while (angle() < to_angle && time < 3 * expected) {
    hold_large();
    groove.step();
    time += dt;
  }
  INFO("ratio " << ratio << ": " << time << " s, rolling takes " << expected << " s");
  CHECK(angle() >= to_angle);
  CHECK(time == Approx(expected).epsilon(2e-3));
  while (groove.position(0).z() > -r && time < 2 * expected) {
    hold_large();
    groove.step();
    time += dt;
  }
  CHECK(groove.position(0).z() <= -r);  // it has fallen off
}
