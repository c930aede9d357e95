// Stress of particles, layers and the bulk where it is known from the weight or from the forces on the boundary.
#include <cmath>

#include <catch2/catch.hpp>

#include "analysis/forces/stress.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/force_fixtures.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

const Layers whole(double height) { return {.bottom = 0, .thickness = height, .count = 1}; }

}  // namespace

TEST_CASE("stress of a column grows by the weight above") {
  const int n = 10;
  const Snapshot s = column(n);
  const double weight = s.mass(0) * 9.8, area = 16;
  const auto result = measured(s, "forces", {.profile_layer = 0.5});
  const auto lower = table_column(result, "stress_profile", "lower"), zz = table_column(result, "stress_profile", "zz");
  REQUIRE(lower.size() == 40);
  for (std::size_t k = 0; k < lower.size(); ++k) {
    INFO("layer " << k);
    // Contacts lie at 0, 2, 4, ...; the branch to the floor ends at the lowest centre, those above join the centres.
    const double height = lower[k] + 0.25;
    const double above = height < 1 ? n : height > 2 * n - 1 ? 0 : n - std::floor((height + 1) / 2);
    CHECK(zz[k] == Approx(above * weight / area).epsilon(1e-8).margin(1e-12));  // overlaps of 1e-9 m
  }
  for (const char* none : {"xx", "yy", "xy", "xz", "yz"}) {
    for (const double value : table_column(result, "stress_profile", none)) CHECK(value == 0);
  }
  // Uniaxial: p = sigma / 3, q = sigma. The bulk's line of force from 10 % to 80 % of the bed's height.
  const double pressure = fixtures::value(result, "stress_pressure");
  CHECK(fixtures::value(result, "stress_major") == Approx(3 * pressure));
  CHECK(fixtures::value(result, "stress_deviator") == Approx(3 * pressure));
  CHECK(fixtures::value(result, "stress_minor") == Approx(0).margin(1e-12));
  CHECK(fixtures::value(result, "stress_major_angle") == Approx(0).margin(1e-6));
  CHECK(fixtures::value(result, "stress_asymmetry") == 0);
  CHECK_FALSE(result.quantity("kinetic_pressure")->value);
}

TEST_CASE("a sphere between two plates: stress of the particle by hand") {
  Snapshot s = column(1, 5);
  s.gravity = Vec3(0, 0, -9.8);
  const double weight = s.mass(0) * 9.8;
  const auto moment = particle_force_moments(s, force_network(s));
  const double arm = 1 - 1e-9;
  CHECK(moment[0](2, 2) == Approx((weight + 5 + 5) * arm).epsilon(1e-12));
  const auto result = measured(s, "forces");
  CHECK(fixtures::value(result, "particle_pressure_mean") ==
        Approx((weight + 10) * arm / 3 / sphere_volume(1)).epsilon(1e-12));
  CHECK(fixtures::value(result, "particle_pressure_deviation") == 0);
}

TEST_CASE("stress of a closed box is what its walls push: volume x stress = sum of wall force (x) place") {
  // A random network with forces of any direction; each particle's balance is closed by a force of the wall.
  Random random(3, RandomStream::filling_position, 1);
  Snapshot s = empty_box(Vec3(10, 10, 10), {false, false, false});
  s.gravity = Vec3::Zero();
  const auto anywhere = [&](double low, double high) {
    return Vec3(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
  };
  for (int i = 0; i < 30; ++i) add_particle(s, anywhere(1, 9), random.uniform(0.3, 0.9));
  add_floor(s);
  std::vector<Vec3> left(s.size(), Vec3::Zero());
  for (std::size_t i = 0; i < s.size(); ++i) {
    for (std::size_t j = i + 1; j < s.size(); j += 7) {
      const Vec3 normal = (s.position[i] - s.position[j]).normalized();
      add_contact(s, i, static_cast<std::int64_t>(j), normal, random.uniform(0, 1), anywhere(-1, 1));
      left[i] += s.contacts->force.back();
      left[j] -= s.contacts->force.back();
    }
  }
  Mat3 boundary = Mat3::Zero();
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3 normal = anywhere(-1, 1).normalized();
    add_contact(s, i, -1, normal, 0, -left[i]);
    const Vec3 place = s.position[i] - (s.radius[i] - 1e-9) * normal;
    boundary -= -left[i] * place.transpose();
  }
  const auto network = force_network(s);
  Mat3 particles = Mat3::Zero();
  for (const Mat3& moment : particle_force_moments(s, network)) particles += moment;
  CHECK((particles - boundary).norm() < 1e-11 * boundary.norm());

  const auto frame = bed_frame(s);
  const Mat3 bulk = 1000 * layer_stress(s, frame, network, whole(10))[0].total();
  CHECK((bulk - boundary).norm() < 1e-11 * boundary.norm());
  Mat3 layers = Mat3::Zero();
  for (const auto& layer : layer_stress(s, frame, network, {.bottom = 0, .thickness = 0.37, .count = 28})) {
    layers += 37 * layer.total();
  }
  CHECK((layers - boundary).norm() < 1e-11 * boundary.norm());
}

TEST_CASE("isotropic pressure on a periodic cubic lattice") {
  // One force f through each bond of length a: sigma = f a / a^3.
  const int n = 4;
  Snapshot s = lattice(simple_cubic, n, n, n, 2.0, 1.0);
  const double f = 0.7;
  const auto row = [&](int i, int j, int k) { return static_cast<std::size_t>(((i % n) * n + j % n) * n + k % n); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        press(s, row(i, j, k), row(i + 1, j, k), f);
        press(s, row(i, j, k), row(i, j + 1, k), f);
        press(s, row(i, j, k), row(i, j, k + 1), f);
      }
    }
  }
  const auto result = measured(s, "forces", {.profile_layer = 1});
  CHECK(fixtures::value(result, "stress_pressure") == Approx(f / 4).epsilon(1e-12));
  CHECK(fixtures::value(result, "stress_deviator") == Approx(0).margin(1e-12));
  CHECK(fixtures::value(result, "stress_minor") == Approx(f / 4).epsilon(1e-12));
  // Vertical bonds go through every layer; level ones lie in those of the centres, at heights 1, 3, 5, 7.
  const auto zz = table_column(result, "stress_profile", "zz"), xx = table_column(result, "stress_profile", "xx");
  REQUIRE(zz.size() == 8);
  double mean = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(zz[k] == Approx(f / 4).epsilon(1e-12));
    mean += xx[k] / 8;
  }
  CHECK(mean == Approx(f / 4).epsilon(1e-12));
  CHECK(fixtures::value(result, "particle_pressure_mean") == Approx(2 * f / sphere_volume(1)).epsilon(1e-12));
  CHECK(result.table("coarse_profile")->rows.size() > 0);
}

TEST_CASE("kinetic stress counts motion against the mean only") {
  Snapshot s = empty_box(Vec3(4, 4, 8), {true, true, true});
  add_particle(s, Vec3(1, 1, 1), 0.5);
  add_particle(s, Vec3(3, 3, 5), 0.5);
  s.fields["velocity"] = {3, "m/s", {10, 0, 3, 10, 0, -3}};
  const double m = s.mass(0);
  s.contacts = Contacts{};
  CHECK(fixtures::value(measured(s, "forces"), "kinetic_pressure") == Approx(2 * m * 9 / 128 / 3).epsilon(1e-12));
  const auto stress = layer_stress(s, bed_frame(s), force_network(s), whole(8))[0].kinetic;
  CHECK(stress(2, 2) == Approx(2 * m * 9 / 128).epsilon(1e-12));
  CHECK(std::abs(stress(0, 0)) < 1e-12 * m);
}

TEST_CASE("principal stresses of a known tensor, largest first") {
  const Vec3 a = Vec3(1, 2, 2) / 3, b = Vec3(2, 1, -2) / 3, c = Vec3(2, -2, 1) / 3;
  Mat3 stress = 1.0 * a * a.transpose() + 5.0 * b * b.transpose() - 2.0 * c * c.transpose();
  stress(0, 1) += 0.3;
  stress(1, 0) -= 0.3;  // the asymmetric part does not matter
  const PrincipalStress axes = principal(stress);
  CHECK((axes.value - Vec3(5, 1, -2)).norm() < 1e-12);
  CHECK(std::abs(axes.direction.col(0).dot(b)) == Approx(1).epsilon(1e-12));
  CHECK(std::abs(axes.direction.col(2).dot(c)) == Approx(1).epsilon(1e-12));
  // q^2 = ((s1 - s2)^2 + (s2 - s3)^2 + (s3 - s1)^2) / 2
  CHECK(deviator(stress) == Approx(std::sqrt((16.0 + 9 + 49) / 2)).epsilon(1e-12));
}
