// Clusters of like particles on lattices.
#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
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

TEST_CASE("a row of spheres across a periodic side: its radius of gyration and extent") {
  Snapshot s = empty_box(Vec3(20, 20, 20), {true, true, false});
  for (const double x : {17.0, 19.0, 1.0, 3.0, 5.0}) add_particle(s, Vec3(x, 9, 9), 1 + 1e-7);
  const auto result = measured(s, "clusters");
  CHECK(value(result, "largest") == 5);
  CHECK(value(result, "largest_gyration_radius") == Approx(2 * std::sqrt((25 - 1) / 12.0)).epsilon(1e-12));
  const auto& row = result.table("largest_clusters")->rows.at(0);
  CHECK(row[3] == Approx(10).epsilon(1e-6));
  CHECK(row[4] == Approx(2).epsilon(1e-6));
  CHECK(row[6] == 0);
}

TEST_CASE("a column of one type percolates along the axis it closes, not along others") {
  // Rows of type 1 along x in a box that repeats along x and y; along z they reach from the floor to the top at one y.
  Snapshot s = cubic_bed(6, 6, 6);
  SECTION("along a periodic axis") {
    label(s, [](int, int y, int z) { return y == 2 && z == 3 ? 1 : 0; });
    const auto result = measured(s, "clusters");
    const auto& rows = result.table("largest_clusters")->rows;
    REQUIRE(rows.size() == 2);
    CHECK(rows[1][1] == 6);
    CHECK((rows[1][6] == 1 && rows[1][7] == 0 && rows[1][8] == 0));
    CHECK(std::isnan(rows[1][2]));  // it has no end
    CHECK(value(result, "percolating_share") == 1);
  }
  SECTION("from the floor to the surface") {
    label(s, [](int x, int y, int) { return x == 2 && y == 3 ? 1 : 0; });
    const auto& rows = measured(s, "clusters").table("largest_clusters")->rows;
    CHECK((rows[1][6] == 0 && rows[1][7] == 0 && rows[1][8] == 1));
    CHECK(rows[1][2] == Approx(2 * std::sqrt(35 / 12.0)));
  }
  SECTION("up to the last layer but one is not through") {
    label(s, [](int x, int y, int z) { return x == 2 && y == 3 && z > 0 && z < 5 ? 1 : 0; });
    CHECK(measured(s, "clusters").table("largest_clusters")->rows[1][8] == 0);
  }
}

TEST_CASE("sites of a cubic lattice percolate above a share of 0.3116") {
  // Stauffer & Aharony, Introduction to Percolation Theory (1994), table 1. Far from it on either side the answer is
  // nearly certain at this size.
  constexpr int edge = 16, trials = 8;
  Snapshot s = cubic_bed(edge, edge, edge, {true, true, true});
  const auto percolating = [&](double share) {
    int count = 0;
    for (int trial = 0; trial < trials; ++trial) {
      Random random(static_cast<std::uint64_t>(trial), RandomStream::filling_position, 0);
      for (std::size_t i = 0; i < s.size(); ++i) s.type[i] = random.uniform() < share ? 1 : 0;
      const auto rows = measured(s, "clusters").table("largest_clusters")->rows;
      for (const auto& row : rows) {
        if (row[0] != 1) continue;
        count += row[6] + row[7] + row[8] > 0;
        break;  // its largest
      }
    }
    return count;
  };
  CHECK(percolating(0.25) == 0);
  CHECK(percolating(0.38) == trials);
}

TEST_CASE("clusters by distance") {
  Snapshot s = empty_box(Vec3(40, 20, 20), {false, false, false});
  for (const double x : {2.0, 4.2, 6.4, 9.0}) add_particle(s, Vec3(x, 5, 5), 1);
  analysis::Options options;
  CHECK(value(measured(s, "clusters"), "largest") == 1);
  options.clusters.gap = 0.3;
  CHECK(value(measured(s, "clusters", options), "largest") == 3);
  options.clusters.gap = 0.7;
  CHECK(value(measured(s, "clusters", options), "largest") == 4);
  s.type[1] = 1;
  CHECK(value(measured(s, "clusters", options), "largest") == 2);
  options.clusters.any_type = true;
  const auto any = measured(s, "clusters", options);
  CHECK(value(any, "largest") == 4);
  CHECK_FALSE(any.quantity("largest_z")->value);
  CHECK(std::isnan(any.table("sizes")->rows.at(0)[0]));
}

TEST_CASE("clusters of strong contacts") {
  Snapshot s = empty_box(Vec3(40, 20, 20), {false, false, false});
  for (const double x : {2.0, 4.0, 6.0, 8.0}) add_particle(s, Vec3(x, 5, 5), 1 + 1e-6);
  s.contacts.emplace();
  const auto press = [&](std::size_t first, std::size_t second, double force) {
    s.contacts->first.push_back(s.id[first]);
    s.contacts->second.push_back(s.id[second]);
    s.contacts->normal.push_back(Vec3(-1, 0, 0));
    s.contacts->force.push_back(Vec3(-force, 0.1, 0));
    s.contacts->overlap.push_back(2e-6);
    s.contacts->point.push_back(Vec3::Zero());
    s.contacts->sliding.push_back(0);
  };
  press(0, 1, 5);
  press(1, 2, 3);
  press(2, 3, 1);  // the mean is 3
  analysis::Options options;
  options.clusters.least_force = 0.9;
  CHECK(value(measured(s, "clusters", options), "largest") == 3);
  options.clusters.least_force = 1.5;
  CHECK(value(measured(s, "clusters", options), "largest") == 2);
  options.clusters.least_force = 2;
  CHECK(value(measured(s, "clusters", options), "largest") == 1);
  s.contacts.reset();
  const auto none = measured(s, "clusters", options);
  CHECK_FALSE(none.quantity("largest")->value);
  CHECK(none.quantity("largest")->note == "the snapshot holds no contact forces");
  options.clusters.gap = 1;
  CHECK_THROWS_AS(measured(s, "clusters", options), InputError);
  options.clusters = {.gap = -1};
  CHECK_THROWS_AS(measured(s, "clusters", options), InputError);
}
