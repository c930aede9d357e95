// Motion and contact forces by hand.
#include <catch2/catch.hpp>

#include "core/geometry.hpp"
#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;

namespace {

Snapshot two_particles() {
  Snapshot s = empty_box(Vec3(10, 10, 10));
  add_particle(s, Vec3(2, 5, 1), 0.5, 0);
  add_particle(s, Vec3(6, 5, 1), 1.0, 1);
  s.fields["velocity"] = {3, "m/s", {3, 0, 4, 0, 1, 0}};
  return s;
}

}  // namespace

TEST_CASE("kinetic energy over m g d") {
  Snapshot s = two_particles();
  const double m1 = 1200 * sphere_volume(0.5), m2 = 7800 * sphere_volume(1.0);
  const double expected = (0.5 * m1 * 25 + 0.5 * m2 * 1) / (9.8 * (m1 * 1.0 + m2 * 2.0));
  auto result = measured(s, "time");
  CHECK(value(result, "kinetic_energy_ratio") == Approx(expected));
  CHECK(value(result, "at_rest") == 0);
  CHECK(value(result, "mean_speed") == Approx(3));
  CHECK(value(result, "max_speed") == Approx(5));
  CHECK(value(result, "contacts_per_particle") == 0);

  for (double& v : s.fields["velocity"].values) v *= 1e-3;
  result = measured(s, "time");
  CHECK(value(result, "kinetic_energy_ratio") == Approx(expected * 1e-6));
  CHECK(value(result, "at_rest") == 1);
}

TEST_CASE("without velocity, gravity or mass the ratio does not apply") {
  Snapshot s = two_particles();
  std::string reason;
  SECTION("no velocity") {
    s.fields.clear();
    reason = "no velocity";
  }
  SECTION("no gravity") {
    s.gravity = Vec3::Zero();
    reason = "no gravity";
  }
  SECTION("no mass") {
    for (auto& group : s.groups) group.density = 0;
    reason = "no mass";
  }
  const auto result = measured(s, "time");
  for (const char* key : {"kinetic_energy_ratio", "at_rest"}) {
    CHECK_FALSE(result.quantity(key)->value);
    CHECK(result.quantity(key)->note.find(reason) != std::string::npos);
  }
}

TEST_CASE("forces of stored contacts") {
  Snapshot s = two_particles();
  CHECK_FALSE(measured(s, "forces").quantity("normal_force_mean")->value);
  CHECK_FALSE(measured(s, "forces").quantity("overlap_max")->value);

  s.boundaries = {{"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}};
  s.contacts = Contacts{{s.id[1], s.id[0]},
                        {s.id[0], -1},
                        {Vec3(4, 0, 3), Vec3(0, 1, 10)},
                        {Vec3::UnitX(), Vec3::UnitZ()},
                        {0.03, 0.01},
                        {Vec3::Zero(), Vec3::Zero()},
                        {1, 0}};
  const auto result = measured(s, "forces");
  CHECK(value(result, "normal_force_mean") == Approx(7));
  CHECK(value(result, "normal_force_max") == Approx(10));
  CHECK(value(result, "sliding_share") == Approx(0.5));
  CHECK(value(result, "overlap_mean") == Approx(0.02 / 0.75));
  CHECK(value(result, "overlap_max") == Approx(0.03 / 0.75));
}
