// The neighbour search against all pairs, and contacts as a snapshot stores them.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "analysis/contact_network.hpp"
#include "analysis/neighbours.hpp"
#include "core/error.hpp"
#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

using Pairs = std::vector<std::tuple<std::uint32_t, std::uint32_t, double>>;

Pairs sorted(const std::vector<NearPair>& pairs) {
  Pairs result;
  for (const auto& p : pairs) result.push_back({std::min(p.first, p.second), std::max(p.first, p.second), p.overlap});
  std::sort(result.begin(), result.end());
  return result;
}

Pairs all_pairs(const Snapshot& s, double gap) {
  std::vector<NearPair> pairs;
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    for (std::uint32_t j = i + 1; j < s.size(); ++j) {
      const double distance = s.domain.separation(s.position[i], s.position[j]).norm();
      const double overlap = s.radius[i] + s.radius[j] - distance;
      if (overlap > -gap) pairs.push_back({i, j, overlap});
    }
  }
  return sorted(pairs);
}

/// Spheres over a size ratio of 40, some outside the box, one without extent.
Snapshot random_mixture(std::size_t count, const Vec3& size, std::array<bool, 3> periodic, std::uint64_t seed) {
  Snapshot s = empty_box(size, periodic);
  Random random(seed, RandomStream::filling_position, 0);
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = random.uniform(-0.1, 1.1) * size[k];
    add_particle(s, p, 0.01 * std::pow(40, random.uniform()));
  }
  s.radius[0] = 0;
  return s;
}

}  // namespace

TEST_CASE("the neighbour search finds what all pairs give") {
  const auto periodic =
      GENERATE(std::array{false, false, false}, std::array{true, true, false}, std::array{true, true, true});
  const auto size = GENERATE(Vec3(3, 3, 3), Vec3(1.7, 4, 2), Vec3(1.65, 1.65, 9));
  const double gap = GENERATE(0.0, 0.02);
  const Snapshot s = random_mixture(600, size, periodic, 11);
  const auto expected = all_pairs(s, gap);
  const auto found = sorted(near_pairs(s.position, s.radius, s.domain, gap));
  REQUIRE(found.size() == expected.size());
  REQUIRE(found.size() > 100);
  for (std::size_t k = 0; k < found.size(); ++k) {
    CHECK(std::get<0>(found[k]) == std::get<0>(expected[k]));
    CHECK(std::get<1>(found[k]) == std::get<1>(expected[k]));
    CHECK(std::get<2>(found[k]) == Approx(std::get<2>(expected[k])).margin(1e-12));
  }
}

TEST_CASE("a particle far away is no trouble for the neighbour search") {
  Snapshot s = random_mixture(200, Vec3(1.65, 1.65, 3), {true, true, false}, 5);
  add_particle(s, Vec3(0, 0, 1e30), 0.1);
  CHECK(near_pairs(s.position, s.radius, s.domain).size() == all_pairs(s, 0).size());
}

TEST_CASE("no particles, no extent: no pairs") {
  const Domain domain;
  CHECK(near_pairs({}, {}, domain).empty());
  const std::vector<Vec3> points(3, Vec3::Zero());
  const std::vector<double> radii(3, 0.0);
  CHECK(near_pairs(points, radii, domain).empty());
}

TEST_CASE("stored contacts are used, gaps among them are none") {
  Snapshot s = empty_box(Vec3(10, 10, 10), {false, false, false});
  for (double x : {1.0, 3.0, 5.0}) add_particle(s, Vec3(x, 5, 1), 1);
  s.boundaries = {{"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}};
  Contacts c;
  const auto add = [&](std::int64_t first, std::int64_t second, double overlap) {
    c.first.push_back(first);
    c.second.push_back(second);
    c.force.push_back(Vec3::Zero());
    c.normal.push_back(Vec3::UnitX());
    c.overlap.push_back(overlap);
    c.point.push_back(Vec3::Zero());
    c.sliding.push_back(0);
  };
  add(s.id[1], s.id[0], 0.01);
  add(s.id[2], s.id[1], -0.01);
  add(s.id[2], -1, 0.02);
  s.contacts = c;
  const ContactNetwork network = contact_network(s);
  REQUIRE(network.pairs.size() == 1);
  CHECK(network.pairs[0].first == 1);
  CHECK(network.pairs[0].second == 0);
  REQUIRE(network.walls.size() == 1);
  CHECK(network.walls[0].row == 2);
  CHECK_FALSE(network.rebuilt);

  const auto structure = measured(s, "structure");
  CHECK(value(structure, "coordination_mean") == Approx(2.0 / 3));
  CHECK(value(structure, "coordination_with_walls") == Approx(1));
  CHECK(structure.quantity("coordination_mean")->note.empty());

  s.contacts->second[0] = 999999;
  CHECK_THROWS_AS(contact_network(s), InputError);
  s.contacts->second[0] = -7;
  CHECK_THROWS_AS(contact_network(s), InputError);
}
