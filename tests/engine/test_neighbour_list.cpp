// The list against brute force over all pairs and images.
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "core/scene.hpp"
#include "engine/detection/neighbour_list.hpp"
#include "engine/simulation.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;

namespace {

using Pairs = std::set<std::pair<std::int32_t, std::int32_t>>;

constexpr double dt = 1e-5;

Particles particles_at(const std::vector<Vec3>& positions, const std::vector<double>& radii) {
  Particles p;
  const std::size_t n = positions.size();
  p.count = n;
  p.mass.resize(n, 1.0);
  p.type.resize(n);
  p.material.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    p.now.rows.push_back({positions[i], radii[i], Vec3::Zero(), 1});
    p.id.push_back(static_cast<std::int32_t>(i));
  }
  std::vector<std::int32_t> slots = p.id;
  slots.push_back(Particles::no_particle);
  p.reorder(slots);
  return p;
}

template <class Visit>
void for_each_particle(Particles& p, Visit&& visit) {
  for (std::size_t s = 0; s < p.slots(); ++s) {
    if (p.is_particle(s)) visit(s);
  }
}

Pairs touching_by_brute_force(Particles& p, const Domain& domain, double scale) {
  Pairs pairs;
  for_each_particle(p, [&](std::size_t i) {
    for_each_particle(p, [&](std::size_t j) {
      const double distance = domain.separation(p.now.rows[i].position, p.now.rows[j].position).norm();
      if (i != j && distance < scale * (p.now.rows[i].radius + p.now.rows[j].radius)) pairs.emplace(p.id[i], p.id[j]);
    });
  });
  return pairs;
}

/// Pairs in the rows that touch as the step sees them: shifted to the nearest image only where the group says so.
Pairs touching_by_list(const Particles& p, const Domain& domain, const NeighbourList& list, double scale) {
  Pairs pairs;
  for (const NeighbourGroup& group : list.groups()) {
    for (std::int64_t row = group.first_row; row < group.first_row + group.rows; ++row) {
      for (int lane = 0; lane < list.width(); ++lane) {
        const std::int32_t j = NeighbourList::slot(list.row(row)[lane]),
                           i = group.shared ? group.slot : group.slot + lane;
        if (j == p.nobody()) continue;
        REQUIRE(p.is_particle(static_cast<std::size_t>(i)));
        const Vec3 a = p.now.rows[i].position, b = p.now.rows[j].position;
        const double distance = group.images ? domain.separation(a, b).norm() : (a - b).norm();
        if (distance < scale * (p.now.rows[i].radius + p.now.rows[j].radius)) {
          REQUIRE(pairs.emplace(p.id[i], p.id[j]).second);
        }
      }
    }
  }
  return pairs;
}

/// What a step tells the list about the motion into its end.
void tell(NeighbourList& list, Particles& p, const Vec3& expected) {
  double largest = 0;
  Vec3 sum = Vec3::Zero();
  for_each_particle(p, [&](std::size_t s) {
    const Vec3 moved = p.now.rows[s].position - list.reference().get(s);
    sum += moved;
    largest = std::max(largest, (moved - expected).squaredNorm() * list.inverse_margin_squared()[s]);
  });
  list.moved(largest, sum, dt);
}

Vec3 uniform_in(Random& r, const Vec3& low, const Vec3& high) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = r.uniform(low[k], high[k]);
  return p;
}

struct Layout {
  const char* name;
  Domain domain;
  std::function<Vec3(Random&)> place;
};

std::vector<Layout> layouts(double largest_radius) {
  const Domain closed{Vec3(-0.2, 0.1, 0), Vec3(0.8, 0.9, 0.5), {false, false, false}};
  Domain periodic = closed, mixed = closed, narrow = closed;
  periodic.periodic = {true, true, true};
  mixed.periodic = {true, false, true};
  narrow.periodic = {true, true, true};
  narrow.max = narrow.min + Vec3::Constant(NeighbourList::least_periodic_side(largest_radius));
  const auto uniform = [](const Domain& d) { return [d](Random& r) { return uniform_in(r, d.min, d.max); }; };
  const auto on_faces_edges_corners = [d = periodic](Random& r) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const double choice = r.uniform();
      p[k] = choice < 0.4 ? d.min[k] : choice < 0.7 ? std::nextafter(d.max[k], 0.0) : r.uniform(d.min[k], d.max[k]);
    }
    return p;
  };
  const auto clustered = [d = mixed](Random& r) { return uniform_in(r, d.max - Vec3::Constant(0.02), d.max); };
  const auto two_clusters = [d = periodic](Random& r) {
    const Vec3 at = r.uniform() < 0.5 ? d.min : Vec3(d.max - Vec3::Constant(0.01));
    return uniform_in(r, at, at + Vec3::Constant(0.01));
  };
  const auto above_the_lid = [d = closed](Random& r) {
    return Vec3(r.uniform(d.min[0], d.max[0]), r.uniform(d.min[1], d.max[1]), r.uniform(0.4, 1.2));
  };
  const auto far_outlier = [d = closed](Random& r) {
    return r.uniform() < 0.02 ? Vec3(1e6 * r.uniform(), 0.5, 0.2) : uniform_in(r, d.min, d.max);
  };
  return {{"closed", closed, uniform(closed)},
          {"periodic", periodic, uniform(periodic)},
          {"mixed", mixed, uniform(mixed)},
          {"narrow", narrow, uniform(narrow)},
          {"on faces, edges and corners", periodic, on_faces_edges_corners},
          {"clustered", mixed, clustered},
          {"two clusters across the corner", periodic, two_clusters},
          {"outside an open face", closed, above_the_lid},
          {"far outliers", closed, far_outlier}};
}

}  // namespace

TEST_CASE("every contact is in the list, once from either side, at any ratio of sizes") {
  const double ratio = GENERATE(1.0, 1.4, 3.0, 10.0, 100.0);
  const int width = GENERATE(1, 8, 16);
  const double largest = 0.06;
  for (const Layout& layout : layouts(largest)) {
    INFO(layout.name << ", ratio " << ratio << ", width " << width);
    std::vector<Vec3> positions;
    std::vector<double> radii;
    for (std::uint64_t i = 0; i < 300; ++i) {
      Random r(7, RandomStream::filling_position, i);
      positions.push_back(layout.place(r));
      radii.push_back(largest * std::pow(ratio, -r.uniform()));
    }
    // One of the largest always, and many of the smallest.
    radii.front() = largest;
    for (std::size_t i = 200; i < 300; ++i) radii[i] = largest / ratio;
    Particles p = particles_at(positions, radii);
    NeighbourList list(layout.domain, width);
    list.build(p, Growth{}, dt);
    const Pairs expected = touching_by_brute_force(p, layout.domain, 1);
    CHECK(expected.size() > 5);
    CHECK(touching_by_list(p, layout.domain, list, 1) == expected);
  }
}

TEST_CASE("no contact is missing in a box a million radii wide, and hardly a pair too many is found") {
  const double radius = 1e-3;
  const bool periodic = GENERATE(true, false);
  const Domain domain{Vec3::Zero(), Vec3::Constant(1e6 * radius), {periodic, periodic, periodic}};
  std::vector<Vec3> positions;
  for (std::uint64_t i = 0; i < 600; ++i) {
    Random r(7, RandomStream::filling_position, i);
    const Vec3 corner = i % 3 == 0 ? domain.min : i % 3 == 1 ? Vec3(0.4999 * domain.max) : domain.max;
    const Vec3 place = corner + uniform_in(r, Vec3::Constant(-8 * radius), Vec3::Constant(8 * radius));
    positions.push_back(periodic ? domain.wrapped(place) : place);
  }
  Particles p = particles_at(positions, std::vector<double>(positions.size(), radius));
  NeighbourList list(domain, 8);
  list.build(p, Growth{}, dt);
  const Pairs expected = touching_by_brute_force(p, domain, 1);
  CHECK(expected.size() > 100);
  CHECK(touching_by_list(p, domain, list, 1) == expected);
  CHECK(static_cast<std::size_t>(list.pairs()) < 3 * expected.size());
}

TEST_CASE("a list that does not call itself outdated misses no contact while particles move and grow") {
  struct Motion {
    const char* name;
    double jump;        ///< of every particle in a step, at random [m]
    double fast;        ///< of every twentieth particle, straight on [m]
    Vec3 common;        ///< of all [m]
    double growth;      ///< a step
    int least_serving;  ///< steps of 300 that need no new list
  };
  const std::vector<Motion> motions = {{"jostling", 2e-4, 0, Vec3::Zero(), 0.002, 150},
                                       {"a few fast ones", 1e-6, 2e-3, Vec3::Zero(), 0, 150},
                                       {"a common fall", 1e-5, 0, Vec3(0, 0, -5e-3), 0, 250},
                                       {"farther in a step than its size", 1e-6, 0.09, Vec3::Zero(), 0, 0}};
  const double ratio = GENERATE(1.0, 10.0);
  for (const Motion& motion : motions) {
    INFO(motion.name << ", ratio " << ratio);
    const Domain domain{Vec3::Zero(), Vec3(0.5, 0.5, 0.5), {true, true, true}};
    std::vector<Vec3> positions;
    std::vector<double> radii;
    for (std::uint64_t i = 0; i < 400; ++i) {
      Random r(9, RandomStream::filling_position, i);
      positions.push_back(uniform_in(r, domain.min, domain.max));
      radii.push_back(i % 8 == 0 ? 0.03 : 0.03 / ratio);
    }
    Particles p = particles_at(positions, radii);
    NeighbourList list(domain, 8);
    Growth growth{0.2, motion.growth / dt};
    int serving = 0;
    for (std::uint64_t step = 0; step < 300; ++step) {
      if (list.outdated(growth)) {
        list.build(p, growth, dt);
      } else {
        ++serving;
      }
      REQUIRE(touching_by_list(p, domain, list, growth.scale) == touching_by_brute_force(p, domain, growth.scale));
      const Vec3 expected = list.expected_displacement();
      for_each_particle(p, [&](std::size_t s) {
        const auto id = static_cast<std::uint64_t>(p.id[s]);
        Random jump(10 + step, RandomStream::filling_position, id), heading(1, RandomStream::filling_position, id);
        Vec3 move = motion.common + motion.jump * uniform_in(jump, -Vec3::Ones(), Vec3::Ones());
        if (id % 20 == 0) move += motion.fast * uniform_in(heading, -Vec3::Ones(), Vec3::Ones()).normalized();
        p.now.rows[s].velocity = move / dt;
        p.now.rows[s].position += move;
      });
      growth.scale = std::min(1.0, growth.scale + motion.growth);
      tell(list, p, expected);
    }
    CHECK(serving >= motion.least_serving);
  }
}

TEST_CASE("a calm bed gets a narrower list, and a share that is not a number a new one") {
  const Domain domain;
  Particles p = particles_at({Vec3(0.5, 0.5, 0.5), Vec3(0.7, 0.5, 0.5)}, {0.1, 0.1});
  NeighbourList list(domain, 8);
  list.build(p, Growth{}, dt);
  const double wide = 1 / std::sqrt(list.inverse_margin_squared()[0]);
  int steps = 0;
  for (; !list.outdated(Growth{}) && steps < 10000; ++steps) list.moved(0, Vec3::Zero(), dt);
  CHECK(steps < 1000);
  list.build(p, Growth{}, dt);
  CHECK(1 / std::sqrt(list.inverse_margin_squared()[0]) < 0.5 * wide);
  CHECK_FALSE(list.outdated(Growth{}));
  list.moved(std::numeric_limits<double>::quiet_NaN(), Vec3::Zero(), dt);
  CHECK(list.outdated(Growth{}));
}

TEST_CASE("a margin that is given is that of every list, and a wider one serves longer") {
  const Domain domain;
  const auto builds = [&](double margin) {
    Particles p = particles_at({Vec3(0.3, 0.5, 0.5), Vec3(0.7, 0.5, 0.5)}, {0.1, 0.05});
    NeighbourList list(domain, 8, 0, margin);
    for (int step = 0; step < 200; ++step) {
      if (list.outdated(Growth{})) {
        list.build(p, Growth{}, dt);
        for_each_particle(p, [&](std::size_t s) {
          CHECK(1 / std::sqrt(list.inverse_margin_squared()[s]) == Approx(margin * p.now.rows[s].radius));
        });
      }
      const Vec3 expected = list.expected_displacement();
      const double jump = step % 2 == 0 ? 1e-3 : -1e-3;
      for_each_particle(p, [&](std::size_t s) { p.now.rows[s].position.x() += p.id[s] == 0 ? jump : 2e-4; });
      tell(list, p, expected);
    }
    return list.builds();
  };
  CHECK(builds(0.5) < builds(0.1));
}

TEST_CASE("particles move alike whatever the margin of the lists") {
  const auto positions = [](const std::string& margin) {
    const Scene scene =
        parse_scene(packstone::testing::small_scene_with("[dynamics]\n", "[dynamics]\n" + margin + "\n"), "margins");
    Snapshot last;
    SimulationEvents events;
    events.snapshot = [&](const Snapshot& s) { last = s; };
    Simulation(scene).run(events);
    std::map<std::int64_t, Vec3> places;
    for (std::size_t row = 0; row < last.size(); ++row) places[last.id[row]] = last.position[row];
    return places;
  };
  const auto automatic = positions("");
  for (const char* margin : {"list_margin = 0.01", "list_margin = 0.8"}) {
    for (const auto& [id, place] : positions(margin)) {
      CHECK((place - automatic.at(id)).norm() < 1e-9);  // m; sums in another order round differently
    }
  }
}

TEST_CASE("the search does not look at more the larger the ratio of sizes is") {
  // One large sphere among as many small ones as fill the box: ranges visited a small particle.
  const auto visited = [](double ratio) {
    const Domain domain{Vec3::Zero(), Vec3::Ones(), {true, true, false}};
    const double small = 0.02;
    VectorArray position;
    AlignedVector<double> extent;
    position.resize(20000);
    for (std::size_t i = 0; i < 20000; ++i) {
      Random r(4, RandomStream::filling_position, i);
      position.set(i, uniform_in(r, domain.min, domain.max));
      extent.push_back(i == 0 ? ratio * small : small);
    }
    HierarchicalGrid grid;
    grid.build(domain, position, extent);
    std::int64_t candidates = 0;
    for (std::size_t k = 0; k < 20000; ++k) {
      grid.for_each_range(grid.spheres().position(k), grid.spheres().extent[k],
                          [&](std::int32_t begin, std::int32_t end) { candidates += end - begin; });
    }
    return static_cast<double>(candidates) / 20000;
  };
  const double equal = visited(1);
  CHECK(equal < 60);  // a box around the reach holds 20000 (3 x 0.04)^3 = 35, its cells some more
  CHECK(visited(3) < 1.2 * equal);
  CHECK(visited(10) < 1.2 * equal);
}
