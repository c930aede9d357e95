// k-cores and communities of networks that are known.
#include <map>

#include <catch2/catch.hpp>

#include "analysis/forces/communities.hpp"
#include "analysis/forces/cores.hpp"
#include "tests/analysis/force_fixtures.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

using Edges = std::vector<WeightedEdge>;

/// All pairs of n nodes from a first one.
void join_all(Edges& edges, std::uint32_t first, std::uint32_t n, double weight) {
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) edges.push_back({first + i, first + j, weight});
  }
}

Edges random_edges(std::uint32_t nodes, std::size_t count, std::uint64_t seed) {
  Random random(seed, RandomStream::filling_position, 0);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> edges;
  while (edges.size() < count) {
    const std::uint32_t a = random.below(nodes), b = random.below(nodes);
    if (a != b) edges[std::minmax(a, b)] = random.uniform();
  }
  Edges list;
  for (const auto& [pair, weight] : edges) list.push_back({pair.first, pair.second, weight});
  return list;
}

/// Largest modularity of all partitions (restricted growth strings).
double best_modularity(const Edges& edges, std::uint32_t nodes, double gamma) {
  double best = -1;
  std::vector<std::uint32_t> label(nodes, 0);
  const auto fill = [&](auto&& self, std::uint32_t node, std::uint32_t used) -> void {
    if (node == nodes) {
      best = std::max(best, geographic_modularity(edges, label, gamma));
      return;
    }
    for (std::uint32_t l = 0; l <= used; ++l) {
      label[node] = l;
      self(self, node + 1, std::max(used, l + 1));
    }
  };
  fill(fill, 0, 0);
  return best;
}

/// Core numbers by their definition: nodes of degree below k taken away until none is left.
std::vector<int> peeled_cores(const Adjacency& near) {
  const std::size_t n = near.begin.size() - 1;
  std::vector<int> core(n, 0);
  for (int k = 1;; ++k) {
    std::vector<char> in(n, 1);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < n; ++i) {
        int degree = 0;
        for (const auto j : near.of(i)) degree += in[j];
        if (in[i] && degree < k) changed = !(in[i] = 0);
      }
    }
    bool any = false;
    for (std::size_t i = 0; i < n; ++i) {
      if (!in[i]) continue;
      core[i] = k;
      any = true;
    }
    if (!any) return core;
  }
}

}  // namespace

TEST_CASE("k-cores of lattices") {
  // Periodic: every node keeps 6 neighbours. Free: the corners go first, 3 is the most.
  CHECK(fixtures::value(measured(lattice(simple_cubic, 5, 5, 5, 2.0, 1 + 1e-7), "forces"), "core_max") == 6);
  CHECK(fixtures::value(measured(lattice(face_centred, 4, 4, 4, 1.0, 0.3536), "forces"), "core_mean") == 12);
  const auto free = measured(cubic_bed(5, 5, 5, {false, false, false}), "forces");
  CHECK(fixtures::value(free, "core_max") == 3);
  CHECK(fixtures::value(free, "core_mean") == 3);
  const auto chain = measured(cubic_bed(1, 1, 6, {false, false, false}), "forces");
  CHECK(fixtures::value(chain, "core_max") == 1);
}

TEST_CASE("k-cores: particles by core number") {
  // A tetrahedron (3-core), a neighbour on one of its particles (1-core), a lone particle.
  Snapshot s = empty_box(Vec3(20, 20, 20), {false, false, false});
  const double a = 1 / std::sqrt(2.0);
  for (const Vec3& corner : {Vec3(1, 0, -a), Vec3(-1, 0, -a), Vec3(0, 1, a), Vec3(0, -1, a)}) {
    add_particle(s, Vec3(5, 5, 5) + corner, 1 + 1e-6);
  }
  add_particle(s, s.position[0] + Vec3(2, 0, 0), 1 + 1e-6);
  add_particle(s, Vec3(15, 15, 15), 1);
  const auto result = measured(s, "forces");
  const auto& rows = result.table("core_numbers")->rows;
  REQUIRE(rows.size() == 4);
  CHECK(rows[0] == std::vector<double>{0, 1, 1.0 / 6});
  CHECK(rows[1][1] == 1);
  CHECK(rows[2][1] == 0);
  CHECK(rows[3][1] == 4);
}

TEST_CASE("core numbers of random networks are those of their definition") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::vector<NearPair> pairs;
    for (const auto& edge : random_edges(80, 100 * seed, seed)) pairs.push_back({edge.first, edge.second, 1});
    const Adjacency near = adjacency(pairs, 80);
    CHECK(core_numbers(near) == peeled_cores(near));
  }
}

TEST_CASE("modularity by hand") {
  // Weights 4, 2, 2, 8; mean 4. Inside {0, 1, 2} and {3, 4}: (4 + 2 - 2 gamma 4) + (8 - gamma 4), over 16.
  const Edges edges = {{0, 1, 4}, {1, 2, 2}, {2, 3, 2}, {3, 4, 8}};
  const std::vector<std::uint32_t> label = {0, 0, 0, 1, 1}, one(5, 0), single = {0, 1, 2, 3, 4};
  CHECK(geographic_modularity(edges, label, 1) == Approx((14.0 - 12) / 16));
  CHECK(geographic_modularity(edges, label, 0.5) == Approx((14.0 - 6) / 16));
  CHECK(geographic_modularity(edges, one, 0.75) == Approx(0.25));
  CHECK(geographic_modularity(edges, single, 1) == 0);
}

TEST_CASE("two dense blobs joined by a weak contact are two communities") {
  Edges edges;
  join_all(edges, 0, 6, 1);
  join_all(edges, 6, 9, 1);
  edges.push_back({2, 8, 0.01});
  const auto label = communities(edges, 15, 1);
  for (std::uint32_t i = 0; i < 15; ++i) CHECK(label[i] == (i < 6 ? 0u : 1u));
  // A small gamma joins them, as the weak contact is above what is expected; a large one leaves single nodes.
  CHECK(communities(edges, 15, 0.001) == std::vector<std::uint32_t>(15, 0));
  CHECK(communities(edges, 15, 2).back() == 14);
}

TEST_CASE("communities of small random networks come near the best of all partitions") {
  double found = 0, best = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Edges edges = random_edges(9, 18, 100 + seed);
    const auto label = communities(edges, 9, 1);
    const double q = geographic_modularity(edges, label, 1), most = best_modularity(edges, 9, 1);
    CHECK(q <= most + 1e-12);
    CHECK(q > 0.9 * most);
    found += q;
    best += most;
  }
  CHECK(found > 0.95 * best);
}

TEST_CASE("no move of one node and no merger improves communities, each is connected") {
  const Edges edges = random_edges(300, 900, 7);
  auto label = communities(edges, 300, 1);
  const double q = geographic_modularity(edges, label, 1);
  const std::uint32_t count = *std::max_element(label.begin(), label.end()) + 1;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const std::uint32_t before = label[i];
    for (std::uint32_t l = 0; l <= count; ++l) {
      label[i] = l;
      REQUIRE(geographic_modularity(edges, label, 1) <= q + 1e-12);
    }
    label[i] = before;
  }
  for (std::uint32_t a = 0; a < count; ++a) {
    for (std::uint32_t b = a + 1; b < count; ++b) {
      auto merged = label;
      std::replace(merged.begin(), merged.end(), b, a);
      REQUIRE(geographic_modularity(edges, merged, 1) <= q + 1e-12);
    }
  }
  std::vector<NearPair> inside;
  for (const auto& edge : edges) {
    if (label[edge.first] == label[edge.second]) inside.push_back({edge.first, edge.second, 1});
  }
  const Adjacency near = adjacency(inside, 300);
  std::vector<char> seen(300, 0);
  std::uint32_t pieces = 0;
  for (std::uint32_t i = 0; i < 300; ++i) {
    if (seen[i]) continue;
    ++pieces;
    std::vector<std::uint32_t> stack{i};
    seen[i] = 1;
    while (!stack.empty()) {
      const auto node = stack.back();
      stack.pop_back();
      for (const auto j : near.of(node)) {
        if (!seen[j]) stack.push_back(j);
        seen[j] = 1;
      }
    }
  }
  CHECK(pieces == count);
}

TEST_CASE("communities of a packing: two hard columns in a soft bed") {
  Snapshot s = cubic_bed(6, 1, 4, {false, false, false});  // x fastest by 4 in z
  add_floor(s);
  const auto row = [](int x, int z) { return static_cast<std::size_t>(x * 4 + z); };
  for (int x = 0; x < 6; ++x) {
    for (int z = 0; z < 4; ++z) {
      if (z > 0) press(s, row(x, z), row(x, z - 1), x == 1 || x == 4 ? 10 : 1);
      if (x > 0) press(s, row(x, z), row(x - 1, z), 1);
    }
    add_contact(s, row(x, 0), -1, Vec3::UnitZ(), 1000);  // a boundary is no member
  }
  const auto result = measured(s, "communities");
  CHECK(fixtures::value(result, "count") == 2);
  CHECK(fixtures::value(result, "largest") == 4);
  CHECK(fixtures::value(result, "mean_size") == 4);
  CHECK(fixtures::value(result, "single_share") == Approx(16.0 / 24));
  // 6 hard contacts of 10 and 32 of 1: total 92, mean 92 / 38.
  CHECK(fixtures::value(result, "modularity") == Approx((60 - 6 * 92.0 / 38) / 92).epsilon(1e-12));
  const auto& sizes = result.table("sizes")->rows;
  REQUIRE(sizes.size() == 2);
  CHECK(sizes[0] == std::vector<double>{1, 16});
  CHECK(sizes[1] == std::vector<double>{4, 2});
  const auto& members = result.table("members")->rows;
  REQUIRE(members.size() == 24);
  for (int z = 0; z < 4; ++z) {
    CHECK(members[row(1, z)][1] == 0);
    CHECK(members[row(4, z)][1] == 1);
  }
}

TEST_CASE("communities where nothing presses") {
  CHECK(measured(cubic_bed(3, 3, 3), "communities").quantity("modularity")->note.find("no contact forces") !=
        std::string::npos);
  Snapshot s = cubic_bed(3, 1, 1);
  s.contacts = Contacts{};
  CHECK(measured(s, "communities").quantity("count")->note == "no contacts");
  press(s, 0, 1, -1);
  CHECK_FALSE(measured(s, "communities").quantity("modularity")->value);
  CHECK(measured(s, "communities").table("members")->rows.empty());
}
