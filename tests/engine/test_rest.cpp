// The quick way to rest against balances known exactly, and against the motion that it stands for.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <omp.h>

#include "core/error.hpp"
#include "engine/contact/head_on.hpp"
#include "engine/contact_pairs.hpp"
#include "engine/rest/relaxation.hpp"
#include "engine/rest/rest_run.hpp"
#include "engine/rest/softening.hpp"
#include "tests/sample_scene.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Contains;
using packstone::testing::small_scene_with;

namespace {

constexpr double rest_gravity = 9.8, rest_density = 1200, rest_stiffness = 1e6;

Scene resting_scene(const std::string& contact = "normal = \"linear\"\n",
                    const std::string& material = "normal_stiffness = 1e6\nnormal_damping = 5\n",
                    const std::string& further = "") {
  return parse_scene(R"(
[dynamics]
goal = "rest"
duration = 1
[domain]
min = [0, 0, 0]
max = [1, 1, 1]
[gravity]
[contact]
)" + contact + "[[material]]\nname = \"m\"\ndensity = 1200\n" +
                         material + R"(
[[particles]]
material = "m"
count = 1
radius = 0.02
[filling]
kind = "random"
[output]
interval = 0.1
[[boundary]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
)" + further,
                     "rest");
}

StartingState standing(const std::vector<Vec3>& centres, const std::vector<double>& radii) {
  StartingState state;
  state.position = centres;
  state.velocity.assign(centres.size(), Vec3(0.1, 0, 0));
  state.angular_velocity.assign(centres.size(), Vec3::Zero());
  state.radius = radii;
  state.type.assign(centres.size(), 0);
  return state;
}

double weight_of(double radius) {
  return rest_density * 4 / 3 * std::numbers::pi * radius * radius * radius * rest_gravity;
}

/// A fine balance.
constexpr RelaxationLimits fine{1e-10, 100000, 0.05};

/// What a run to rest tells, snapshots by time.
struct Told {
  std::vector<Snapshot> snapshots;
  std::vector<std::vector<double>> rows;
  std::vector<std::string> columns;

  SimulationEvents events() {
    SimulationEvents e;
    e.snapshot = [this](const Snapshot& s) { snapshots.push_back(s); };
    e.history = [this](const std::vector<std::string>& names, const std::vector<double>& row) {
      columns = names;
      rows.push_back(row);
    };
    return e;
  }
  double last(const std::string& column) const {
    return rows.back()[std::find(columns.begin(), columns.end(), column) - columns.begin()];
  }
};

/// 120 spheres of 20 mm, grown over a floor.
Scene small_bed(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all = {"dynamics.goal=\"rest\"", "dynamics.time_step=\"auto\"", "dynamics.duration=2",
                                  "output.history_interval=0.001"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return parse_scene(packstone::testing::small_scene, "small", all);
}

/// 150 spheres of 10 mm sink onto a floor, chi = 2000.
Scene overdamped_bed(const std::vector<std::string>& overrides) {
  return parse_scene(R"(
[dynamics]
kind = "overdamped"
viscosity = 3.7
duration = 120
[domain]
min = [0, 0, 0]
max = [0.12, 0.12, 0.2]
periodic = ["x", "y"]
open = ["z+"]
[gravity]
[contact]
normal = "linear"
[[material]]
name = "m"
density = 1200
normal_stiffness = 1e4
[[particles]]
material = "m"
count = 150
radius = 0.01
[filling]
kind = "random"
[[boundary]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
[output]
interval = 10
history_interval = 0.2
)",
                     "overdamped bed", overrides);
}

}  // namespace

TEST_CASE("A column relaxes to the overlaps that bear what stands above", "[rest]") {
  const std::vector<double> radii = {0.02, 0.03, 0.015, 0.02};
  std::vector<Vec3> centres;
  double z = 0;
  for (const double r : radii) {
    centres.emplace_back(0.5, 0.5, z + r);
    z += 2 * r;
  }
  const double young = 1e7, poisson = 0.3;
  const bool hertz = GENERATE(false, true);
  const Scene scene =
      hertz ? resting_scene("normal = \"hertz\"\n", "young_modulus = 1e7\npoisson_ratio = 0.3\nrestitution = 0.5\n")
            : resting_scene();
  StartingState state = standing(centres, radii);
  const Relaxation done = relax(scene, state, fine, {});
  CHECK(done.balance.unbalanced < 1e-10);
  double above = 0, top = 0;
  for (std::size_t i = radii.size(); i-- > 0;) {
    above += weight_of(radii[i]);
    const double r = i > 0 ? radii[i] * radii[i - 1] / (radii[i] + radii[i - 1]) : radii[i];
    const double modulus = 0.5 * young / (1 - poisson * poisson);
    const double overlap =
        hertz ? std::pow(above / (4.0 / 3 * std::sqrt(r) * modulus), 2.0 / 3) : above / rest_stiffness;
    const double gap = i > 0 ? state.position[i][2] - state.position[i - 1][2] - radii[i] - radii[i - 1]
                             : state.position[0][2] - radii[0];
    CHECK(-gap == Approx(overlap).epsilon(1e-7));
    CHECK(state.velocity[i].isZero(0));
    top = std::max(top, overlap);
  }
  CHECK(top > 1e-7);
}

TEST_CASE("A sphere rolls down into a groove and is borne by both sides", "[rest]") {
  const Scene scene = resting_scene("normal = \"hysteretic\"\n", "normal_stiffness = 1e6\nnormal_damping = 0.7\n", R"(
[[boundary]]
name = "left"
kind = "plane"
point = [0.5, 0, 0.1]
normal = [1, 0, 1]
[[boundary]]
name = "right"
kind = "plane"
point = [0.5, 0, 0.1]
normal = [-1, 0, 1]
)");
  StartingState state = standing({{0.42, 0.5, 0.25}}, {0.02});
  const Relaxation done = relax(scene, state, fine, {});
  CHECK(done.balance.largest_over_weight < 1e-6);
  const double overlap = weight_of(0.02) / std::sqrt(2.0) / rest_stiffness;
  CHECK(state.position[0][0] == Approx(0.5).margin(1e-9));
  CHECK(state.position[0][2] == Approx(0.1 + std::sqrt(2.0) * (0.02 - overlap)).margin(1e-9));
}

TEST_CASE("Relaxation says when overlaps at rest are beyond their limit, and can be stopped", "[rest]") {
  const Scene soft = resting_scene("normal = \"linear\"\n", "normal_stiffness = 100\nnormal_damping = 0\n");
  StartingState state = standing({{0.5, 0.5, 0.019}}, {0.02});
  CHECK_THROWS_WITH(relax(soft, state, {1e-6, 10000, 0.05}, {}), Contains("make the material stiffer"));
  CHECK_THROWS_AS(relax(soft, state, fine, [] { return true; }), Interrupted);
}

TEST_CASE("A softened contact keeps its restitution", "[rest]") {
  const auto [contact, material] = GENERATE(table<std::string, std::string>(
      {{"normal = \"linear\"\n", "normal_stiffness = 1e6\nnormal_damping = 5\n"},
       {"normal = \"linear\"\nrelease = \"zero-force\"\n", "normal_stiffness = 1e6\nrestitution = 0.6\n"},
       {"normal = \"hertz\"\n", "young_modulus = 1e7\npoisson_ratio = 0.3\nnormal_damping = 0.5\n"},
       {"normal = \"hertz\"\n", "young_modulus = 1e7\npoisson_ratio = 0.3\nrestitution = 0.6\n"},
       {"normal = \"kuwabara-kono\"\n", "young_modulus = 1e7\npoisson_ratio = 0.3\ndissipation_time = 1e-4\n"},
       {"normal = \"kuwabara-kono\"\n",
        "young_modulus = 1e7\npoisson_ratio = 0.3\nshear_viscosity = 500\nbulk_viscosity = 900\n"},
       {"normal = \"hysteretic\"\n", "normal_stiffness = 1e6\nnormal_damping = 0.7\n"}}));
  const Scene hard = resting_scene(contact, material);
  const Scene soft = softened(hard, 0.01);
  const Population population = population_of(hard, standing({{0.5, 0.5, 0.5}}, {0.02}));
  const double power = is_hertzian(hard.contact.normal) ? 0.4 : 0.5;
  constexpr double speed = 0.5;
  for (std::size_t k = 0; k < contact_pairs(hard, population).size(); ++k) {
    const ContactPair a = contact_pairs(hard, population)[k], b = contact_pairs(soft, population)[k];
    const Impact one = impact_of(hard, *a.a, *a.b, a.size, speed), other = impact_of(soft, *b.a, *b.b, b.size, speed);
    CAPTURE(contact, material, a.name, one.restitution);
    CHECK(one.restitution < 0.99);
    CHECK(other.restitution == Approx(one.restitution).epsilon(1e-4));
    CHECK(other.largest_overlap == Approx(one.largest_overlap * std::pow(0.01, -power)).epsilon(1e-4));
  }
}

TEST_CASE("Softening stops where the bed's weight or a fall would press too deep", "[rest]") {
  Scene scene = resting_scene();
  const Population population = population_of(scene, standing({{0.5, 0.5, 0.5}}, {0.02}));
  const double solid = 0.3;  // a bed half a metre high
  const Softening deep = softening(scene, population, solid);
  const double column = solid / 0.6 / 0.04;
  CHECK(deep.factor < 1);
  CHECK(std::max(deep.resting_overlap / *scene.dynamics.way_overlap, deep.impact_overlap / 0.1) == Approx(1));
  CHECK(deep.resting_overlap == Approx(column * weight_of(0.02) / (deep.factor * rest_stiffness) / 0.02));
  scene.dynamics.way_overlap = 1e-9;
  CHECK(softening(scene, population, solid).factor == 1);
}

TEST_CASE("A run to rest ends with the floor bearing the bed", "[rest]") {
  const Scene scene = small_bed({"dynamics.unbalanced_force=0.001"});
  RestRun run(scene);
  Told told;
  run.run(told.events());
  const double mass = run.scene().materials[0].density + run.scene().materials[1].density;
  const double weight = 60 * mass * 4 / 3 * std::numbers::pi * 8e-6 * rest_gravity;
  CHECK(-told.last("floor.force_z") == Approx(weight).epsilon(2e-4));
  CHECK(told.last("max_speed") < 1e-3);
  CHECK(told.last("particles") == 120);
  CHECK_THAT(run.ending(), Contains("at rest") && !Contains("not at rest"));
  CHECK(run.way().factor < 1);
  CHECK(told.snapshots.back().step == run.steps_done());
  for (std::size_t k = 1; k < told.rows.size(); ++k) CHECK(told.rows[k][1] > told.rows[k - 1][1]);
  for (const Snapshot& s : told.snapshots) CHECK(s.scene_hash == scene_hash(run.scene()));
  CHECK(run.scene().materials[0].normal_stiffness == scene.materials[0].normal_stiffness);
}

TEST_CASE("A run to rest has the same bits for any number of threads", "[rest]") {
  std::vector<Snapshot> ends;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    RestRun run(small_bed());
    Told told;
    run.run(told.events());
    ends.push_back(told.snapshots.back());
  }
  CHECK(ends[0].position == ends[1].position);
  CHECK(ends[0].time == ends[1].time);
}

TEST_CASE("With friction a run to rest ends in the scene's own motion", "[rest]") {
  const Scene scene =
      small_bed({"contact.tangential=\"cundall-strack\"", "material[0].friction=0.5", "material[1].friction=0.5",
                 "material[0].tangential_stiffness=1e6", "material[1].tangential_stiffness=1e6",
                 "contact.normal=\"linear\"", "material[0].normal_damping=20", "material[1].normal_damping=20"});
  RestRun run(scene);
  Told told;
  run.run(told.events());
  CHECK_THAT(run.ending(), Contains("at rest") && Contains("of motion at full stiffness"));
  CHECK(told.last("kinetic_translational") > 0);
  const double falls = 60 * (1200 + 7800) * 4.0 / 3 * std::numbers::pi * 8e-6 * rest_gravity * 0.04;  // sum of m g d
  CHECK(told.last("kinetic_translational") < 5.1e-5 * falls);
}

TEST_CASE("A run to rest that gets no time says what it lacks", "[rest]") {
  RestRun run(small_bed({"dynamics.duration=0.06"}));
  CHECK_THROWS_WITH(run.run({}), Contains("has not come down in dynamics.duration"));
}

TEST_CASE("An overdamped run to rest ends in the bed of the whole motion", "[rest]") {
  constexpr int seeds = 2;
  double quick_fraction = 0, whole_fraction = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    RestRun quick(
        overdamped_bed({fmt::format("seed={}", seed), "dynamics.goal=\"rest\"", "dynamics.way_overlap=0.01"}));
    Told told;
    quick.run(told.events());
    CHECK_THAT(quick.ending(), Contains("at rest") && !Contains("not at rest"));
    CHECK(quick.way().factor < 1);
    CHECK(quick.work().steps > 0);
    CHECK(-told.last("floor.force_z") == Approx(150 * weight_of(0.01)).epsilon(0.01));
    CHECK(told.last("unbalanced_force") < 1);
    for (std::size_t k = 1; k < told.rows.size(); ++k) CHECK(told.rows[k][1] > told.rows[k - 1][1]);
    quick_fraction += told.last("packing_fraction") / seeds;

    Simulation whole(overdamped_bed({fmt::format("seed={}", seed), "dynamics.rest_force=0.05"}));
    Told all;
    whole.run(all.events());
    whole_fraction += all.last("packing_fraction") / seeds;
  }
  CHECK(quick_fraction == Approx(whole_fraction).margin(0.015));
  CHECK_THROWS_WITH(RestRun(overdamped_bed({"dynamics.goal=\"rest\"", "dynamics.duration=0.5"})).run({}),
                    Contains("unbalanced force is still above 0.05"));
}

TEST_CASE("A bed does not rest before the slowest spheres have sunk", "[rest]") {
  // The smallest sink five times as slowly as the largest, and weigh a fifth.
  RestRun quick(overdamped_bed({"dynamics.goal=\"rest\"", "dynamics.way_overlap=0.01", "dynamics.duration=300",
                                "particles[0].radius={distribution=\"uniform\",min=0.006,max=0.01}"}));
  SimulationEvents events;
  double highest = 0;
  events.snapshot = [&](const Snapshot& s) {
    highest = 0;
    for (const Vec3& place : s.position) highest = std::max(highest, place[2]);
  };
  quick.run(events);
  constexpr double deep = 0.06;  // the solid volume over the floor and a fraction of 0.55, and a diameter
  CHECK(highest < deep);
}

TEST_CASE("Scenes whose bed depends on the way are refused", "[rest]") {
  const auto refused = [](const std::vector<std::string>& overrides, const std::string& why) {
    CHECK_THROWS_WITH(small_bed(overrides), Contains(why));
  };
  CHECK_THROWS_WITH(overdamped_bed({"dynamics.list_margin=0.1"}), Contains("dynamics.list_margin"));
  CHECK_THROWS_WITH(overdamped_bed({"dynamics.goal=\"rest\"", "dynamics.way_energy=0.01"}),
                    Contains("has no kinetic energy"));
  refused({"gravity.end=1"}, "lies under gravity");
  refused({"contact.van_der_waals.hamaker=1e-19"}, "stick more");
  refused({"contact.normal=\"walton-braun\""}, "largest overlap");
  CHECK_THROWS_WITH(parse_scene(packstone::testing::small_scene, "small", {"dynamics.way_overlap=0.01"}),
                    Contains("dynamics.way_overlap") && Contains("goes with dynamics.goal"));
}
