// Clusters of like particles on lattices.
#include <catch2/catch.hpp>

#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;

TEST_CASE("a checkerboard has single particles only") {
  Snapshot s = cubic_bed(6, 6, 6);
  label(s, [](int x, int y, int z) { return (x + y + z) % 2; });
  const auto result = measured(s, "clusters");
  CHECK(value(result, "count") == 216);
  CHECK(value(result, "count_of_several") == 0);
  CHECK(value(result, "largest") == 1);
  CHECK(value(result, "mean_size") == 1);
  CHECK(value(result, "mean_size_by_mass") == Approx(1));
  CHECK(value(result, "like_contact_share") == 0);
  CHECK(value(result, "like_contact_share_z") < -10);
  CHECK(value(result, "count_z") > 10);
}

TEST_CASE("two halves are two clusters") {
  Snapshot s = cubic_bed(6, 6, 6);
  label(s, [](int, int, int z) { return z < 2 ? 1 : 0; });
  const auto result = measured(s, "clusters");
  CHECK(value(result, "count") == 2);
  CHECK(value(result, "count_of_several") == 2);
  CHECK(value(result, "largest") == 144);
  CHECK(value(result, "mean_size") == 108);
  const double light = 144 * 1200.0, heavy = 72 * 7800.0;
  CHECK(value(result, "mean_size_by_mass") == Approx((light * 144 + heavy * 72) / (light + heavy)));
  // 216 pairs along x and as many along y, 180 along z, 36 of these between the halves.
  CHECK(value(result, "like_contact_share") == Approx(1 - 36.0 / 612));
  const auto& rows = result.table("sizes")->rows;
  REQUIRE(rows.size() == 2);
  CHECK(rows[0] == std::vector<double>{0, 144, 1});
  CHECK(rows[1] == std::vector<double>{1, 72, 1});
}

TEST_CASE("random labels: like contacts as often as pairs of like particles") {
  Snapshot s = cubic_bed(8, 8, 8);
  label_at_random(s, 4);
  const auto result = measured(s, "clusters");
  const double n = 512, like_pairs = (n / 2 - 1) / (n - 1);
  CHECK(value(result, "like_contact_share_random") == Approx(like_pairs).epsilon(0.01));
  CHECK(std::abs(value(result, "like_contact_share_z")) < 4);
  CHECK(std::abs(value(result, "count_z")) < 4);
}

TEST_CASE("one type: clusters without a random reference") {
  Snapshot s = cubic_bed(4, 4, 4);
  const auto result = measured(s, "clusters");
  CHECK(value(result, "count") == 1);
  CHECK_FALSE(result.quantity("count_z")->value);
  CHECK_FALSE(result.quantity("count_random")->note.empty());
}

TEST_CASE("no contacts, no mass, no particles") {
  Snapshot s = empty_box(Vec3(20, 20, 20));
  CHECK_FALSE(measured(s, "clusters").quantity("count")->value);
  add_particle(s, Vec3(5, 5, 5), 1, 0);
  add_particle(s, Vec3(15, 15, 15), 1, 1);
  CHECK_FALSE(measured(s, "clusters").quantity("like_contact_share")->value);
  CHECK(value(measured(s, "clusters"), "count") == 2);
  for (auto& group : s.groups) group.density = 0;
  CHECK_FALSE(measured(s, "clusters").quantity("mean_size_by_mass")->value);
}
