// Mixing indices of beds whose composition is known by hand.
#include <cmath>

#include <catch2/catch.hpp>

#include "analysis/context.hpp"
#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;

namespace {

/// A cubic bed cut exactly between its layers.
analysis::MeasureResult segregation_of(const Snapshot& s) {
  return measured(s, "segregation", {.segregation_layer = 2});
}

}  // namespace

TEST_CASE("a separated bed: Lacey 0, intensity 1") {
  Snapshot s = cubic_bed(6, 6, 10);
  label(s, [](int, int, int z) { return z < 5 ? 1 : 0; });
  const auto result = segregation_of(s);
  CHECK(value(result, "lacey") == Approx(0).margin(1e-4));
  CHECK(value(result, "intensity") == Approx(1).epsilon(1e-4));
  CHECK(value(result, "height_difference") == Approx(0.5).epsilon(1e-3));
  CHECK(result.quantity("height_difference")->note == "higher: light, lower: heavy");
  CHECK(value(result, "lacey_z") < -50);
  CHECK(value(result, "intensity_z") > 50);
}

TEST_CASE("a checkerboard: mixed better than at random") {
  Snapshot s = cubic_bed(6, 6, 10);
  label(s, [](int x, int y, int z) { return (x + y + z) % 2; });
  const auto result = segregation_of(s);
  CHECK(value(result, "lacey") > 1);
  CHECK(value(result, "intensity") == Approx(0).margin(1e-9));
  CHECK(value(result, "height_difference") == Approx(0).margin(1e-9));
}

TEST_CASE("composition by layer and its random spread are those by hand") {
  Snapshot s = cubic_bed(6, 6, 10);
  label(s, [](int x, int, int z) { return z == 0 && x < 2 ? 1 : 0; });  // 12 heavy in the lowest layer
  const auto result = segregation_of(s);
  const auto& rows = result.table("composition")->rows;
  const double p = 12.0 / 360, n = 36, total = 360;
  const double spread = std::sqrt(p * (1 - p) / n * (total - n) / (total - 1));
  const auto& heavy = rows[1];
  CHECK(heavy[2] == 1);
  CHECK(heavy[3] == Approx(1.0 / 3).epsilon(1e-4));
  CHECK(heavy[4] == Approx(p));
  CHECK(heavy[5] == Approx(spread).epsilon(1e-4));
  CHECK(heavy[6] == Approx((1.0 / 3 - p) / spread).epsilon(1e-3));
  // s^2 by hand: one layer of ten with 1/3, nine with nothing.
  const double variance = 0.1 * std::pow(1.0 / 3 - p, 2) + 0.9 * p * p;
  CHECK(value(result, "intensity") == Approx(variance / (p * (1 - p))).epsilon(1e-3));
  const double random = p * (1 - p) / n * (total - n) / (total - 1);
  CHECK(value(result, "lacey") == Approx((p * (1 - p) - variance) / (p * (1 - p) - random)).epsilon(1e-3));
}

TEST_CASE("three types have an index too") {
  Snapshot s = cubic_bed(4, 4, 9);
  s.groups.push_back({"third", "light", 2000});
  label(s, [](int, int, int z) { return z / 3; });
  const auto separated = segregation_of(s);
  CHECK(value(separated, "lacey") == Approx(0).margin(1e-4));
  CHECK(value(separated, "height_difference") == Approx(2.0 / 3).epsilon(0.05));
  CHECK(separated.table("types")->rows.size() == 3);
  label(s, [](int x, int y, int z) { return (x + y + z) % 3; });
  CHECK(value(segregation_of(s), "lacey") > 0.95);
}

TEST_CASE("where there is nothing to mix the answer says so") {
  Snapshot s = cubic_bed(4, 4, 4);
  std::string reason;
  SECTION("one type") { reason = "one type"; }
  SECTION("no particles") {
    s = empty_box(Vec3(1, 1, 1));
    reason = "no particles";
  }
  SECTION("one layer") {
    s = cubic_bed(4, 4, 1);
    label(s, [](int x, int, int) { return x % 2; });
    reason = "one layer";
  }
  SECTION("no volume yet") {
    s = cubic_bed(4, 4, 4);
    label(s, [](int x, int, int) { return x % 2; });
    std::fill(s.radius.begin(), s.radius.end(), 0.0);
    reason = "no solid volume";
  }
  const auto result = measured(s, "segregation", {.segregation_layer = 2.1});
  for (const char* key : {"lacey", "lacey_random", "lacey_z", "intensity", "intensity_z", "height_difference"}) {
    INFO(key);
    REQUIRE(result.quantity(key));
    CHECK_FALSE(result.quantity(key)->value);
    CHECK(result.quantity(key)->note.find(reason) != std::string::npos);
  }
}

TEST_CASE("two particles: random mixing cannot be told from separation") {
  Snapshot s = empty_box(Vec3(4, 4, 10));
  add_particle(s, Vec3(2, 2, 1), 1, 0);
  add_particle(s, Vec3(2, 2, 3), 1, 1);
  const auto result = segregation_of(s);
  CHECK_FALSE(result.quantity("lacey")->value);
  CHECK(value(result, "intensity") == Approx(1));
}
