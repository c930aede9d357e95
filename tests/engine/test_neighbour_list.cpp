// The list against brute force over all pairs and images.
#include <algorithm>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "engine/detection/neighbour_list.hpp"

using namespace packstone;
using namespace packstone::engine;

namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

Particles particles_at(const std::vector<Vec3>& positions, const std::vector<double>& radii) {
  Particles p;
  p.now.resize(positions.size(), false);
  for (std::size_t i = 0; i < positions.size(); ++i) p.now.position.set(i, positions[i]);
  p.radius = radii;
  return p;
}

Pairs touching_by_brute_force(const Particles& p, const Domain& domain, double scale) {
  Pairs pairs;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < p.size(); ++j) {
      const double distance = domain.separation(p.now.position.get(i), p.now.position.get(j)).norm();
      if (i != j && distance < scale * (p.radius[i] + p.radius[j])) pairs.emplace(i, j);
    }
  }
  return pairs;
}

/// Pairs whose listed image really touches.
Pairs touching_by_list(const Particles& p, const NeighbourList& list, double scale) {
  Pairs pairs;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = list.first(i); k < list.last(i); ++k) {
      const auto j = static_cast<std::size_t>(list.entry(k).index);
      const Vec3 d = p.now.position.get(i) - p.now.position.get(j) - list.shift(list.entry(k).image);
      if (d.norm() < scale * (p.radius[i] + p.radius[j])) REQUIRE(pairs.emplace(i, j).second);
    }
  }
  return pairs;
}

struct Layout {
  const char* name;
  Domain domain;
  std::function<Vec3(Random&)> place;
};

std::vector<Layout> layouts() {
  const Domain closed{Vec3(-0.2, 0.1, 0), Vec3(0.8, 0.9, 0.5), {false, false, false}};
  Domain periodic = closed, mixed = closed, narrow = closed;
  periodic.periodic = {true, true, true};
  mixed.periodic = {true, false, true};
  narrow.periodic = {true, true, true};
  narrow.max = narrow.min + Vec3::Constant(NeighbourList::least_periodic_side(0.04));
  const auto uniform = [](const Domain& d) {
    return [d](Random& r) {
      Vec3 p;
      for (int k = 0; k < 3; ++k) p[k] = r.uniform(d.min[k], d.max[k]);
      return p;
    };
  };
  const auto on_faces = [d = periodic](Random& r) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const double choice = r.uniform();
      p[k] = choice < 0.4 ? d.min[k] : choice < 0.7 ? std::nextafter(d.max[k], 0.0) : r.uniform(d.min[k], d.max[k]);
    }
    return p;
  };
  const auto clustered = [d = mixed](Random& r) {
    return Vec3(d.max - Vec3(0.02 * r.uniform(), 0.02 * r.uniform(), 0.02 * r.uniform()));
  };
  const auto above_the_lid = [d = closed](Random& r) {
    return Vec3(r.uniform(d.min[0], d.max[0]), r.uniform(d.min[1], d.max[1]), r.uniform(0.4, 1.2));
  };
  return {{"closed", closed, uniform(closed)},
          {"periodic", periodic, uniform(periodic)},
          {"mixed", mixed, uniform(mixed)},
          {"narrow", narrow, uniform(narrow)},
          {"on faces", periodic, on_faces},
          {"clustered", mixed, clustered},
          {"outside an open face", closed, above_the_lid}};
}

}  // namespace

TEST_CASE("every contact is in the list, once from either side") {
  for (const Layout& layout : layouts()) {
    for (std::uint64_t trial = 0; trial < 3; ++trial) {
      INFO(layout.name << ", trial " << trial);
      std::vector<Vec3> positions;
      std::vector<double> radii;
      for (std::uint64_t i = 0; i < 300; ++i) {
        Random r(trial, RandomStream::filling_position, i);
        positions.push_back(layout.place(r));
        radii.push_back(r.uniform(0.004, 0.04));
      }
      Particles p = particles_at(positions, radii);
      NeighbourList list(layout.domain, 0.04);
      list.build(p, Growth{});
      const Pairs expected = touching_by_brute_force(p, layout.domain, 1);
      CHECK(expected.size() > 10);
      CHECK(touching_by_list(p, list, 1) == expected);
    }
  }
}

TEST_CASE("a list that does not call itself outdated misses no contact while particles move and grow") {
  Domain domain{Vec3::Zero(), Vec3(0.5, 0.5, 0.5), {true, true, true}};
  std::vector<Vec3> positions;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Random r(9, RandomStream::filling_position, i);
    positions.emplace_back(r.uniform(0, 0.5), r.uniform(0, 0.5), r.uniform(0, 0.5));
  }
  Particles p = particles_at(positions, std::vector<double>(400, 0.03));
  NeighbourList list(domain, 0.03);
  Growth growth{0.2, 0};
  list.build(p, growth);
  double moved = 0;
  int serving = 0;
  for (std::uint64_t step = 0; step < 300; ++step) {
    growth.scale += 0.002;
    for (std::size_t i = 0; i < p.size(); ++i) {
      Random r(10 + step, RandomStream::filling_position, i);
      const Vec3 jump(r.uniform(-1, 1), r.uniform(-1, 1), r.uniform(-1, 1));
      p.now.position.set(i, p.now.position.get(i) + 2e-4 * jump);
      moved = std::max(moved, (p.now.position.get(i) - list.reference().get(i)).squaredNorm());
    }
    if (list.outdated(moved, growth)) {
      list.build(p, growth);
      moved = 0;
    } else {
      ++serving;
    }
    REQUIRE(touching_by_list(p, list, growth.scale) == touching_by_brute_force(p, domain, growth.scale));
  }
  CHECK(serving > 200);
}

TEST_CASE("a displacement that is not a number calls for a rebuild") {
  Domain domain;
  Particles p = particles_at({Vec3(0.5, 0.5, 0.5)}, {0.1});
  NeighbourList list(domain, 0.1);
  list.build(p, Growth{});
  CHECK_FALSE(list.outdated(0, Growth{}));
  CHECK(list.outdated(std::numeric_limits<double>::quiet_NaN(), Growth{}));
  CHECK(list.outdated(std::numeric_limits<double>::infinity(), Growth{}));
}
