// Friction against textbook motions of a sphere on a plane, and its bookkeeping.
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "engine/contact/cundall_strack.hpp"
#include "hand_made.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::contact_scene;
using engine::testing::HandMade;
using engine::testing::Sphere;

namespace {

Scene friction_scene(double friction, bool floor) {
  return contact_scene("normal = \"linear\"\ntangential = \"cundall-strack\"",
                       "normal_damping = 5\ntangential_stiffness = 1e6\nfriction = " + std::to_string(friction), floor);
}

/// Height at which a sphere rests on the floor.
double resting_height(const Vec3& gravity) {
  const double mass = 1200 * 4.0 / 3.0 * M_PI * std::pow(0.02, 3);
  return 0.02 - mass * std::abs(gravity.z()) / 1e6;
}

using Vector = simd::Vector<double>;
using Kept = std::array<double, CundallStrack::most_kept>;

/// One step of a contact with k_s = 1e6 N/m.
TangentialForce<double> slid(double friction, const Vector& n, const Vector& velocity, double normal_force, double dt,
                             Kept& kept) {
  const double overlap = 1e-5;
  return CundallStrack::advance(CundallStrack::Parameters<double>{1e6, friction},
                                Slip<double>{n, velocity, normal_force, overlap, dt}, kept);
}

}  // namespace

TEST_CASE("a sliding sphere slows by mu g, then rolls at five sevenths of its speed") {
  const double mu = 0.3, g = 9.8, v0 = 0.5;
  HandMade ball(friction_scene(mu, true), {{Vec3(0.3, 0.5, resting_height(Vec3(0, 0, -g))), Vec3(v0, 0, 0)}}, 1e-5);
  ball.input.gravity = Vec3(0, 0, -g);
  const double rolling_from = 2 * v0 / (7 * mu * g);
  auto run_to = [&, n = 0](double time) mutable {
    for (; n * 1e-5 < time; ++n) ball.step();
  };
  run_to(0.5 * rolling_from);
  CHECK(ball.velocity(0).x() == Approx(v0 - mu * g * 0.5 * rolling_from).epsilon(2e-3));
  run_to(3 * rolling_from);
  CHECK(ball.velocity(0).x() == Approx(5.0 / 7.0 * v0).epsilon(2e-3));
  CHECK(ball.angular_velocity(0).y() * 0.02 == Approx(5.0 / 7.0 * v0).epsilon(2e-3));
}

TEST_CASE("a sphere rolls down a slope at five sevenths of g sin(theta), slides with little friction") {
  const double theta = 0.4, g = 9.8;
  const Vec3 gravity(g * std::sin(theta), 0, -g * std::cos(theta));
  const auto acceleration = [&](double mu) {
    HandMade ball(friction_scene(mu, true), {{Vec3(0.2, 0.5, resting_height(gravity))}}, 1e-5);
    ball.input.gravity = gravity;
    for (int n = 0; n < 20000; ++n) ball.step();
    return ball.velocity(0).x() / 0.2;
  };
  CHECK(acceleration(0.5) == Approx(5.0 / 7.0 * g * std::sin(theta)).epsilon(3e-3));
  // Below mu = 2/7 tan(theta) the contact slides.
  CHECK(acceleration(0.05) == Approx(g * (std::sin(theta) - 0.05 * std::cos(theta))).epsilon(3e-3));
}

TEST_CASE("swapping the bodies gives exactly the opposite force") {
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    Random r(1, RandomStream::filling_position, trial);
    const auto vector = [&] { return Vector{r.uniform(-1, 1), r.uniform(-1, 1), r.uniform(-1, 1)}; };
    const auto same = [](const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    Vector n = vector();
    n = 1 / std::sqrt(squared_length(n)) * n;
    const Vector spring = 1e-5 * vector();
    Vector velocity = vector();
    velocity -= dot(velocity, n) * n;
    Kept a{}, b{};
    keep_vector(spring, a);
    keep_vector(-spring, b);
    const auto there = slid(0.4, n, velocity, 20.0, 1e-5, a);
    const auto back = slid(0.4, -n, -velocity, 20.0, 1e-5, b);
    REQUIRE(same(there.force, -back.force));
    REQUIRE(same(kept_vector(a), -kept_vector(b)));
    REQUIRE(std::sqrt(squared_length(there.force)) <= 0.4 * 20 * (1 + 1e-12));
    REQUIRE(std::abs(dot(there.force, n)) < 1e-9);
  }
}

TEST_CASE("friction turns slip into heat and no more") {
  Kept spring{};
  const Vector n{0, 0, 1}, velocity{0.1, 0, 0};
  double work = 0, heat = 0, stored = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto f = slid(0.5, n, velocity, 10.0, 1e-6, spring);
    work -= dot(f.force, velocity) * 1e-6;
    heat += f.dissipated;
    stored = f.elastic;
  }
  CHECK(heat > 0);
  CHECK(work == Approx(heat + stored).epsilon(1e-3));
}

TEST_CASE("a sphere that rocks on its friction's spring neither gains nor loses") {
  // The contact point swings at sqrt(3.5 k_s / m): the sphere turns as it moves. Its velocity is sampled half a step
  // off.
  const double g = 9.8, mass = 1200 * 4.0 / 3.0 * M_PI * std::pow(0.02, 3), swing = std::sqrt(3.5 * 1e6 / mass);
  const double dt = 0.65 / swing, speed = 1e-4;
  const auto kept = [&](double lead, int steps) {
    HandMade ball(friction_scene(1.0, true), {{Vec3(0.3, 0.5, resting_height(Vec3(0, 0, -g))), Vec3(speed, 0, 0)}}, dt);
    ball.input.gravity = Vec3(0, 0, -g);
    ball.input.velocity_lead = lead * dt;
    double largest = 0;
    for (int n = 0; n < steps + 20; ++n) {
      ball.step();
      const double slip = ball.velocity(0).x() - 0.02 * ball.angular_velocity(0).y();
      if (n >= steps) largest = std::max(largest, std::abs(slip));
    }
    return largest / speed;
  };
  const double half_step_off = std::cos(std::asin(0.65 / 2));  // of the discrete swing
  CHECK(kept(0, 5000) == Approx(1 / half_step_off).epsilon(2e-3));
  CHECK(kept(0, 20000) == Approx(kept(0, 5000)).epsilon(2e-3));
  // The velocity at the instant stands for a later one: it damps, by about (w dt)^2 / 4 a step.
  CHECK(kept(0.5, 100) < 1e-5);
}

TEST_CASE("a spring whose force follows sgn(v_s), as [24] prints it, does not give back what it took") {
  // A body of mass m on a spring alone, from s = 0 with speed v: after half a period it should come back with -v.
  const double m = 0.04, k = 1e5, v0 = 0.01, dt = 1e-6;
  const double half_period = std::numbers::pi * std::sqrt(m / k);
  const auto speed_after = [&](bool as_printed) {
    double s = 0, v = v0;
    for (int n = 0; n < half_period / dt; ++n) {
      const double force = as_printed ? -k * std::abs(s) * (v > 0 ? 1 : -1) : -k * s;
      v += force / m * dt;
      s += v * dt;
    }
    return v;
  };
  CHECK(speed_after(false) == Approx(-v0).epsilon(1e-3));
  CHECK(std::abs(speed_after(true)) < 0.01 * v0);  // it is caught where it turned, pushed to and fro from step to step
}

TEST_CASE("an oblique collision keeps momentum exactly and angular momentum to the overlap's share of the radius") {
  HandMade pair(friction_scene(0.3, false),
                {{Vec3(0.4, 0.5, 0.5), Vec3(1, 0.3, 0)}, {Vec3(0.4405, 0.51, 0.5), Vec3(-1, 0, 0.2)}}, 1e-7);
  const auto angular = [&] {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 2; ++i) {
      sum += pair.mass(i) * pair.position(i).cross(pair.velocity(i));
      sum += pair.inertia(i) * pair.angular_velocity(i);
    }
    return sum;
  };
  const Vec3 momentum = pair.momentum(), spin = angular();
  for (int n = 0; n < 20000; ++n) pair.step();
  CHECK((pair.velocity(0) - Vec3(1, 0.3, 0)).norm() > 0.5);
  CHECK(pair.angular_velocity(0).norm() > 1);
  CHECK((pair.momentum() - momentum).norm() < 1e-13);
  const double orbital = pair.mass(0) * 0.04 * 2;
  CHECK((angular() - spin).norm() < 0.01 * orbital);
}

TEST_CASE("rebuilding the list keeps the contact's history to the bit") {
  // Two spheres rub in a corner of the box; far away a third one races and forces rebuilds.
  const Scene scene = friction_scene(0.4, false);
  const std::vector<Sphere> pair = {{Vec3(0.1, 0.1, 0.1), Vec3(0.05, 0.03, 0)},
                                    {Vec3(0.1398, 0.1, 0.1), Vec3(-0.05, 0, 0)}};
  std::vector<Sphere> with_racer = pair;
  with_racer.push_back({Vec3(0.5, 0.5, 0.5), Vec3(40, 0, 0)});
  HandMade quiet(scene, pair, 1e-6), busy(scene, with_racer, 1e-6);
  for (int n = 0; n < 400; ++n) {
    quiet.step();
    busy.step();
  }
  CHECK(busy.dynamics->neighbours().builds() > quiet.dynamics->neighbours().builds() + 1);
  CHECK(quiet.angular_velocity(0).norm() > 0);
  CHECK(quiet.position(0) == busy.position(0));
  CHECK(quiet.angular_velocity(0) == busy.angular_velocity(0));
}

TEST_CASE("without friction nothing turns and nothing is kept") {
  Scene scene = friction_scene(0.0, true);
  CHECK_FALSE(rotates(scene));
  scene = friction_scene(0.1, true);
  CHECK(rotates(scene));
}
