// Force chains in networks built by hand.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "analysis/forces/force_chains.hpp"
#include "tests/analysis/force_fixtures.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

ForceChains chains_of(const Snapshot& s, const ForceOptions& options = {}) {
  return force_chains(s, force_network(s), options);
}

/// Centres of a triangular lattice of spheres of radius 1 in the plane y = 2: rows 0 .. n-1 from the top, 2 n particles
/// a row; odd rows are shifted by a radius.
Snapshot triangular(int n) {
  Snapshot s = empty_box(Vec3(4 * n + 4, 4, 2 * n + 2), {false, false, false});
  const double height = std::sqrt(3.0);
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < 2 * n; ++i) add_particle(s, Vec3(2 * i + 2 + k % 2, 2, 2 * n - k * height), 1);
  }
  return s;
}

}  // namespace

TEST_CASE("a column without load: the lower part of it is one chain") {
  // Particle k of n = 9 carries (2 (n - k) - 1) weights on its two contacts; the mean is 9, above it are k = 0 .. 3.
  const auto chains = chains_of(column(9));
  REQUIRE(chains.length.size() == 1);
  CHECK(chains.length[0] == 4);
  CHECK(chains.links.size() == 3);
  CHECK(chains.branch_points == 0);
  const auto result = measured(column(9), "forces");
  CHECK(value(result, "chain_count") == 1);
  CHECK(value(result, "chain_length_mean") == 4);
  CHECK(value(result, "chain_particle_share") == Approx(4.0 / 9));
  CHECK(value(result, "chain_angle_mean") == Approx(0).margin(1e-6));
}

TEST_CASE("the threshold: half the mean takes in more of the column, three means nothing") {
  CHECK(chains_of(column(9), {.chain_threshold = 0}).length == std::vector<std::uint32_t>{9});
  // Above 4.5 weights: 17, 15, 13, 11, 9, 7, 5.
  CHECK(chains_of(column(9), {.chain_threshold = 0.5}).length == std::vector<std::uint32_t>{7});
  CHECK(chains_of(column(9), {.chain_threshold = 3}).length.empty());
  const auto result = measured(column(9), "forces", {.forces = {.chain_threshold = 3}});
  CHECK(value(result, "chain_count") == 0);
  CHECK_FALSE(result.quantity("chain_length_mean")->value);
  CHECK(result.table("chain_links")->rows.empty());
}

TEST_CASE("equal stresses are not above their mean") {
  Snapshot s = column(8, 1e9);
  for (auto& force : s.contacts->force) force = force.normalized();
  CHECK(chains_of(s).length.empty());
}

TEST_CASE("a point load on a triangular lattice makes two chains that part at the load") {
  // A vertical load of 2 cos 30 on the top particle goes down both lattice directions with force 1.
  const int n = 8;
  Snapshot s = triangular(n);
  const auto row = [&](int k, int i) { return static_cast<std::size_t>(k * 2 * n + i); };
  const int middle = n;
  add_floor(s);
  add_contact(s, row(0, middle), -1, -Vec3::UnitZ(), std::sqrt(3.0));
  int left = middle, right = middle;
  for (int k = 1; k < n; ++k) {
    const int next_left = k % 2 ? left - 1 : left, next_right = k % 2 ? right : right + 1;
    press(s, row(k - 1, left), row(k, next_left), 1);
    press(s, row(k - 1, right), row(k, next_right), 1);
    left = next_left;
    right = next_right;
  }
  for (int k = 0; k < n; ++k) {  // weak neighbours of the strong lines, below the mean
    for (int i = 0; i + 1 < 2 * n; ++i) press(s, row(k, i), row(k, i + 1), 1e-3);
  }
  const auto chains = chains_of(s);
  // The load's particle has its largest stress along the vertical, 30 degrees from both lines: one chain of 2 n - 1.
  REQUIRE(chains.length == std::vector<std::uint32_t>{2 * n - 1});
  CHECK(chains.links.size() == 2 * n - 2);
  CHECK(chains.branch_points == 0);
  // Within 20 degrees the lines no longer join at the load.
  CHECK(chains_of(s, {.chain_angle = 20}).length == std::vector<std::uint32_t>{n - 1, n - 1});

  const auto result = measured(s, "forces");
  CHECK(value(result, "chain_angle_mean") == Approx(30).epsilon(1e-9));
  const auto& directions = result.table("chain_directions")->rows;
  REQUIRE(directions.size() == 9);
  CHECK(directions[2][2] + directions[3][2] == 2 * n - 2);  // 30 degrees is a border
  const auto& links = result.table("chain_links")->rows;
  REQUIRE(links.size() == 2 * n - 2);
  CHECK(links[0][0] == 0);
  CHECK(links[0][1] == s.id[row(0, middle)]);
  CHECK(links[0][2] == s.id[row(1, middle - 1)]);
  CHECK(links[0][3] == Approx(1));
}

TEST_CASE("a pyramid: the load of the top goes down four edges that meet in a branching point") {
  // Five layers of a square pyramid of spheres (fcc, square layers): sphere on four others, lines at 45 degrees. A load
  // L on the top gives each of four lines the force F = L / (4 cos 45).
  Snapshot s = empty_box(Vec3(20, 20, 20), {false, false, false});
  const double down = std::sqrt(2.0), load = 8;
  const int layers = 5;
  add_particle(s, Vec3(10, 10, 15), 1);
  add_floor(s);
  add_contact(s, 0, -1, -Vec3::UnitZ(), load);
  const double force = load / (4 * std::cos(std::numbers::pi / 4));
  for (const Vec3& side : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0)}) {
    std::size_t above = 0;
    for (int k = 1; k < layers; ++k) {
      add_particle(s, s.position[above] + side - down * Vec3::UnitZ(), 1);
      press(s, s.size() - 1, above, force);
      above = s.size() - 1;
    }
    add_contact(s, above, -1, Vec3::UnitZ(), force / 2, force / 2 * side);
  }
  // Bystanders that touch lightly pull the mean down.
  for (int k = 0; k < 40; ++k) {
    add_particle(s, Vec3(1 + k % 10, 1 + k / 10, 1), 0.5);
    if (k > 0) press(s, s.size() - 1, s.size() - 2, 1e-3);
  }
  const auto chains = chains_of(s, {.chain_angle = 46});
  REQUIRE(chains.length.size() == 1);
  CHECK(chains.length[0] == 1 + 4 * (layers - 1));
  CHECK(chains.branch_points == 1);
  CHECK(chains.particles == 17);
  // Lines exactly at the angle are within it, any rounding apart; at 44 degrees the top is left out.
  CHECK(chains_of(s).length == std::vector<std::uint32_t>{17});
  CHECK(chains_of(s, {.chain_angle = 44}).length == std::vector<std::uint32_t>(4, layers - 1));
}

TEST_CASE("forces across the lines of centres make no chains") {
  // Zigzag neighbours whose own stress, from plates on both sides, is across the contact between them.
  Snapshot s = empty_box(Vec3(40, 4, 4), {false, false, false});
  add_floor(s);
  for (int k = 0; k < 10; ++k) {
    add_particle(s, Vec3(2 * k + 1, 2, 2), 1);
    if (k > 0) press(s, static_cast<std::size_t>(k), static_cast<std::size_t>(k - 1), 1 + k % 3);
    add_contact(s, static_cast<std::size_t>(k), -1, Vec3::UnitZ(), 100 + k);
    add_contact(s, static_cast<std::size_t>(k), -1, -Vec3::UnitZ(), 100 + k);
  }
  CHECK(chains_of(s).length.empty());
  CHECK(chains_of(s, {.chain_threshold = 0}).length.empty());
  CHECK(chains_of(s, {.chain_threshold = 0, .chain_angle = 90}).length == std::vector<std::uint32_t>{10});
}

TEST_CASE("chains go on over periodic sides, in any order of rows, and are numbered by ids") {
  // Two level lines of four through the periodic side; the second has the lower ids.
  Snapshot s = empty_box(Vec3(8, 8, 8), {true, true, true});
  for (int line = 0; line < 2; ++line) {
    for (int k = 0; k < 4; ++k) add_particle(s, Vec3(2 * k + 0.5, 2 + 4 * line, 2), 1);
  }
  add_particle(s, Vec3(1, 4, 6), 0.5);
  add_particle(s, Vec3(2, 4, 6), 0.5);
  for (std::size_t i = 0; i < s.size(); ++i) s.id[i] = 100 - static_cast<std::int64_t>(i);
  for (std::size_t line = 0; line < 2; ++line) {
    for (std::size_t k = 0; k < 4; ++k) {
      press(s, 4 * line + (k + 1) % 4, 4 * line + k, 5);
      CHECK(s.domain.separation(s.position[4 * line + (k + 1) % 4], s.position[4 * line + k]).norm() == Approx(2));
    }
  }
  press(s, 8, 9, 0.01);
  const auto chains = chains_of(s);
  REQUIRE(chains.length == std::vector<std::uint32_t>{4, 4});
  REQUIRE(chains.links.size() == 8);
  CHECK(chains.links[0].chain == 0);
  CHECK(s.id[chains.links[0].first] < 97);
  const auto result = measured(s, "forces");
  CHECK(value(result, "chain_angle_mean") == Approx(90));
  CHECK(table_column(result, "chain_lengths", "chains") == std::vector<double>{2});
}
