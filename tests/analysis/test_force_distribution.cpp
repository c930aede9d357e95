// Distribution of forces drawn from known laws, and friction.
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <omp.h>

#include "analysis/writers.hpp"
#include "core/error.hpp"
#include "tests/analysis/force_fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;

namespace {

/// Pairs of touching particles along x, each pair pressed by a force of the caller's.
Snapshot pairs(std::size_t count) {
  Snapshot s = empty_box(Vec3(4.0 * static_cast<double>(count), 4, 4), {false, false, false});
  for (std::size_t k = 0; k < 2 * count; ++k) add_particle(s, Vec3(2.0 * static_cast<double>(k) + 1, 2, 1), 1);
  return s;
}

/// Materials grain (mu 0.4) and steel (mu 0.1), floor of steel.
const char* const scene_with_friction = R"(
[dynamics]
duration = "1 s"
[domain]
min = [0, 0, 0]
max = [1000, 4, 4]
[contact]
normal = "linear"
tangential = "cundall-strack"
[[material]]
name = "grain"
density = 1000
normal_stiffness = 1e7
tangential_stiffness = 1e7
normal_damping = 0
friction = 0.4
[[material]]
name = "steel"
density = 7800
normal_stiffness = 1e7
tangential_stiffness = 1e7
normal_damping = 0
friction = 0.1
[[particles]]
material = "grain"
count = 2
radius = "1 m"
[filling]
kind = "growth"
duration = "0.1 s"
[output]
interval = "0.1 s"
history_interval = "10 ms"
[[boundary]]
name = "floor"
kind = "plane"
material = "steel"
point = [0, 0, 0]
normal = [0, 0, 1]
)";

}  // namespace

TEST_CASE("exponential forces: rate of the tail and histogram") {
  // Midpoints of equal shares of the law exp(-x): the sample has no noise, so the rate is known far better than its
  // standard error. Cut at x > 1 the law is the same exponential: beta = 1.
  const std::size_t n = 4000;
  Snapshot s = pairs(n);
  double mean = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double force = -3 * std::log((static_cast<double>(k) + 0.5) / static_cast<double>(n));
    mean += force / static_cast<double>(n);
    press(s, 2 * k, 2 * k + 1, force);
  }
  const auto result = measured(s, "forces");
  CHECK(value(result, "normal_force_mean") == Approx(mean).epsilon(1e-12));
  CHECK(value(result, "normal_force_tail") == Approx(1).epsilon(5e-3));
  CHECK(*result.quantity("normal_force_tail")->uncertainty == Approx(1 / std::sqrt(n * std::exp(-1))).epsilon(0.01));
  const auto lower = table_column(result, "normal_force_distribution", "lower");
  const auto count = table_column(result, "normal_force_distribution", "count");
  const auto density = table_column(result, "normal_force_distribution", "density");
  CHECK(std::accumulate(count.begin(), count.end(), 0.0) == n);
  for (std::size_t k = 0; k < 20; ++k) {
    // Mean of exp(-x) over the bin; the sample differs by less than two of its particles.
    const double exact = (std::exp(-lower[k]) - std::exp(-lower[k] - 0.1)) / 0.1;
    CHECK(std::abs(density[k] - exact) < 2 / (0.1 * n) + 1e-3);
  }
  CHECK(result.table("tangential_force_distribution")->rows.empty());
}

TEST_CASE("forces give the same bits for any number of threads") {
  Snapshot s = pairs(6000);
  Random random(2, RandomStream::filling_position, 0);
  std::vector<double> velocity;
  for (std::size_t k = 0; k < 3 * s.size(); ++k) velocity.push_back(random.uniform());
  s.fields["velocity"] = {3, "m/s", velocity};
  for (std::size_t k = 0; k + 1 < s.size(); ++k) press(s, k, k + 1, random.uniform());
  const int before = omp_get_max_threads();
  const auto with_threads = [&](int threads) {
    omp_set_num_threads(threads);
    return analysis::to_json(analysis::analyze(s, {"forces", "communities"}));
  };
  const auto one = with_threads(1), three = with_threads(3);
  omp_set_num_threads(before);
  CHECK(one == three);
}

TEST_CASE("one contact, equal forces and forces that pull have no tail") {
  Snapshot s = pairs(3);
  press(s, 0, 1, 2);
  CHECK(value(measured(s, "forces"), "tangential_force_mean") == 0);
  CHECK_FALSE(measured(s, "forces").quantity("normal_force_tail")->value);
  press(s, 2, 3, 2);
  CHECK_FALSE(measured(s, "forces").quantity("normal_force_tail")->value);
  CHECK(measured(s, "forces").table("normal_force_distribution")->rows.size() == 1);
  press(s, 4, 5, -100);
  const auto result = measured(s, "forces");
  CHECK(value(result, "normal_force_mean") == Approx(-32));
  CHECK(result.quantity("normal_force_tail")->note.find("does not press") != std::string::npos);
  CHECK(result.table("normal_force_distribution")->rows.empty());
}

TEST_CASE("forces beyond twenty means count in the last bin") {
  Snapshot s = pairs(51);
  for (std::size_t k = 0; k < 50; ++k) press(s, 2 * k, 2 * k + 1, 1e-6);
  press(s, 100, 101, 50);
  const auto result = measured(s, "forces");
  const auto upper = table_column(result, "normal_force_distribution", "upper");
  const auto count = table_column(result, "normal_force_distribution", "count");
  CHECK(upper.back() == Approx(20));
  CHECK(count.back() == 1);
  CHECK(count.front() == 50);
}

TEST_CASE("tangential forces and mobilised friction") {
  Snapshot s = pairs(2);
  add_floor(s);
  s.material_names = {"grain", "steel"};
  add_contact(s, 0, 1, -Vec3::UnitX(), 10, Vec3(0, 3, 0));
  add_contact(s, 2, 3, -Vec3::UnitX(), 5, Vec3(0, 0, 1));
  add_contact(s, 0, -1, Vec3::UnitZ(), 2, Vec3(0.1, 0, 0));
  add_contact(s, 1, -1, Vec3::UnitZ(), -1, Vec3(0.5, 0, 0));  // pulls: no ratio
  auto result = measured(s, "forces");
  CHECK(value(result, "tangential_force_mean") == Approx((3 + 1 + 0.1 + 0.5) / 4));
  CHECK(value(result, "friction_ratio_mean") == Approx((0.3 + 0.2 + 0.05) / 3));
  CHECK(result.quantity("friction_mobilised_mean")->note.find("no scene") != std::string::npos);

  s.scene_text = scene_with_friction;
  result = measured(s, "forces");
  INFO(result.quantity("friction_mobilised_mean")->note);
  REQUIRE(result.quantity("friction_mobilised_mean")->value);
  // mu = 0.4 between grains, sqrt(0.4 x 0.1) = 0.2 on the floor.
  CHECK(value(result, "friction_mobilised_mean") == Approx((0.3 / 0.4 + 0.2 / 0.4 + 0.05 / 0.2) / 3));

  s.material_names = {"sand", "steel"};
  CHECK(measured(s, "forces").quantity("friction_mobilised_mean")->note.find("does not name") != std::string::npos);
  s.scene_text = "not a scene";
  CHECK(measured(s, "forces").quantity("friction_mobilised_mean")->note.find("cannot be read") != std::string::npos);
}

TEST_CASE("contacts that cannot be understood are refused") {
  Snapshot s = pairs(1);
  press(s, 0, 1, 1);
  SECTION("a force that is not a number") { s.contacts->force[0].y() = std::nan(""); }
  SECTION("an infinite overlap") { s.contacts->overlap[0] = INFINITY; }
  SECTION("a particle that is not there, across a gap") {
    s.contacts->second[0] = 5;
    s.contacts->overlap[0] = -1;
  }
  SECTION("a boundary that is not there") { s.contacts->second[0] = -3; }
  CHECK_THROWS_AS(measured(s, "forces"), InputError);
}

TEST_CASE("ids far apart find their rows") {
  Snapshot s = pairs(1);
  s.id = {-4'000'000'000'000'000'000, 9'000'000'000'000'000'000};
  press(s, 1, 0, 3);
  s.contacts->first[0] = s.id[1];
  s.contacts->second[0] = s.id[0];
  // A negative second is a boundary: only ids from 0 on can be partners.
  CHECK_THROWS_AS(measured(s, "forces"), InputError);
  s.id[0] = 4;
  s.contacts->second[0] = 4;
  CHECK(value(measured(s, "forces"), "normal_force_mean") == 3);
}

TEST_CASE("options of forces must make sense") {
  const Snapshot s = column(3);
  const auto refused = [&](const analysis::ForceOptions& forces) {
    analysis::Options options;
    options.forces = forces;
    CHECK_THROWS_AS(measured(s, "forces", options), InputError);
  };
  refused({.chain_threshold = -1});
  refused({.chain_angle = 0});
  refused({.chain_angle = 91});
  refused({.kernel_width = -1});
  refused({.kernel_width = INFINITY});
  refused({.resolution = 0});
}
