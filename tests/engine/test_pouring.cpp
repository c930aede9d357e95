// Particles that come in over time, stages, and gravity that changes.
#include <cmath>
#include <map>
#include <set>

#include <catch2/catch.hpp>
#include <omp.h>

#include "core/error.hpp"
#include "engine/simulation.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Contains;

namespace {

const std::string common = R"(
[contact]
normal = "linear"
[[material]]
name = "m"
density = 2500
normal_stiffness = 1e5
restitution = 0.3
[[material]]
name = "n"
density = 1000
normal_stiffness = 1e5
restitution = 0.3
[[particles]]
material = "m"
count = 60
radius = "5 mm"
[[particles]]
material = "n"
count = 30
radius = "4 mm"
[[boundary]]
name = "box"
kind = "box"
min = [0, 0, 0]
max = [0.06, 0.06, 0.3]
[domain]
min = [-0.01, -0.01, -0.01]
max = [0.07, 0.07, 0.31]
[output]
interval = 0.05
history_interval = 0.005
)";
const std::string falls = "[gravity]\nacceleration = [0, 0, -9.8]\n";
const std::string run_for = "[dynamics]\ntime_step = 2e-5\nduration = ";
const std::string poured = "[filling]\nkind = \"pour\"\nregion_min = [0, 0, 0.2]\nregion_max = [0.06, 0.06, 0.3]\n";

struct Ran {
  std::vector<Snapshot> snapshots;
  std::vector<std::map<std::string, double>> history;
  std::vector<std::string> warnings;
};

Ran run(const std::string& text) {
  Simulation simulation(parse_scene(text, "pour"));
  Ran ran;
  SimulationEvents events;
  events.snapshot = [&](const Snapshot& s) { ran.snapshots.push_back(s); };
  events.history = [&](const auto& columns, const auto& row) {
    ran.history.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) ran.history.back()[columns[k]] = row[k];
  };
  simulation.run(events);
  ran.warnings = simulation.warnings();
  return ran;
}

}  // namespace

TEST_CASE("poured particles come at their rate, mixed, apart from each other, and all of them") {
  const Ran ran = run(common + falls + "[dynamics]\ntime_step = 5e-6\nduration = 0.4\n" + poured +
                      "rate = 300\nvelocity = [0, 0, -1]\n");
  for (const auto& row : ran.history) {
    const double due = std::min(90.0, 1 + std::floor(300 * row.at("time")));
    CHECK(row.at("particles") <= due);
    CHECK(row.at("particles") >= due - 2);  // looked for room every 50 steps, 1 ms
    CHECK(row.at("max_overlap") < 0.05);
  }
  const Snapshot& last = ran.snapshots.back();
  REQUIRE(last.size() == 90);
  CHECK(std::count(last.type.begin(), last.type.end(), 0) == 60);
  const auto early = std::count(last.type.begin(), last.type.begin() + 45, 0);
  CHECK(early > 22);  // 30 of one group expected among the first half, and no more than chance off
  CHECK(early < 38);
  for (std::size_t i = 0; i < last.size(); ++i) CHECK(last.radius[i] == (last.type[i] == 0 ? 5e-3 : 4e-3));
  CHECK(std::abs(ran.history.back().at("energy_error")) < 0.02 * ran.history.back().at("dissipated"));
}

TEST_CASE("pouring has the same bits for any number of threads") {
  const std::string scene = common + falls + run_for + "0.2\n" + poured + "rate = 500\n";
  const int threads = omp_get_max_threads();
  std::vector<std::vector<Vec3>> ends;
  for (const int count : {1, 2}) {
    omp_set_num_threads(count);
    ends.push_back(run(scene).snapshots.back().position);
  }
  omp_set_num_threads(threads);
  REQUIRE(ends[0].size() == ends[1].size());
  for (std::size_t i = 0; i < ends[0].size(); ++i) CHECK(ends[0][i] == ends[1][i]);
}

TEST_CASE("pouring ends at its mass or height, and what cannot be poured is said") {
  const double heavy = 2500 * 4.0 / 3.0 * M_PI * std::pow(5e-3, 3);
  const Ran by_mass = run(common + falls + run_for + "0.3\n" + poured +
                          "rate = 1000\nmost_mass = " + std::to_string(20 * heavy) + "\n");
  double mass = 0;
  for (const auto type : by_mass.snapshots.back().type) mass += type == 0 ? heavy : heavy * 0.4 * std::pow(0.8, 3);
  CHECK(mass <= 20 * heavy);
  CHECK(mass > 19 * heavy);
  const Ran by_height = run(common + falls + run_for + "1.6\n" + poured + "rate = 60\nfill_height = 0.018\n");
  double top = 0;
  const Snapshot& end = by_height.snapshots.back();
  for (std::size_t i = 0; i < end.size(); ++i) top = std::max(top, end.position[i].z() + end.radius[i]);
  CHECK(top > 0.016);
  CHECK(top < 0.032);  // what was in the air came on top
  CHECK(by_height.snapshots.back().size() < 90);

  CHECK_THROWS_WITH(run(common + falls + run_for + "0.1\n" + poured + "rate = 300\n"),
                    Contains("filling.rate") && Contains("31 in the run's 0.1 s, and 90 are asked for"));
  // Without gravity nothing makes room.
  CHECK_THROWS_AS(
      run(common + run_for + "0.1\n" +
          "[filling]\nkind = \"pour\"\nregion_min = [0, 0, 0.28]\nregion_max = [0.06, 0.06, 0.3]\nrate = 2000\n"),
      RunError);
  CHECK_THROWS_WITH(run(common + falls + run_for + "0.1\n" + poured), Contains("either rate"));
  CHECK_THROWS_WITH(run(common + falls + run_for + "0.1\n[filling]\nkind = \"pour\"\nrate = 3\n"),
                    Contains("needs region_min"));
  CHECK_THROWS_WITH(run(common + falls + run_for + "0.1\n[filling]\nkind = \"random\"\nrate = 3\n"),
                    Contains("filling.rate: goes with kind = \"pour\""));
}

TEST_CASE("portions come when the one before has come to rest") {
  const Ran ran =
      run(common + falls + run_for + "4\nrest_speed = 0.01\n" + poured + "portions = 3\nrest_speed = 0.02\n");
  std::set<int> levels;
  double before = 0;
  for (std::size_t k = 0; k < ran.history.size(); ++k) {
    const double now = ran.history[k].at("particles");
    levels.insert(static_cast<int>(now));
    if (k > 1 && now > before && (before == 30 || before == 60)) {
      CHECK(ran.history[k - 1].at("kinetic_translational") < 0.5 * 90 * 1.31e-3 * 0.02 * 0.02);
    }
    before = now;
  }
  CHECK(levels.count(30) == 1);
  CHECK(levels.count(60) == 1);
  CHECK(before == 90);
  CHECK(ran.history.back().at("time") < 3.9);  // rest ended the run
}

TEST_CASE("stages follow each other at their time or at rest, and boundaries know them") {
  const std::string scene =
      common + falls + "[dynamics]\ntime_step = 2e-5\n" +
      "[filling]\nkind = \"random\"\nregion_min = [0, 0, 0.05]\nregion_max = [0.06, 0.06, 0.3]\n" +
      "[[stage]]\nname = \"settle\"\nduration = 3\nrest_speed = 0.02\n" +
      "[[stage]]\nname = \"lift\"\nduration = 0.1\n[[stage]]\nname = \"wait\"\nduration = 0.05\n" +
      "[[boundary]]\nname = \"lid\"\nkind = \"plane\"\npoint = [0, 0, 0.05]\nnormal = [0, 0, 1]\n"
      "stages = [\"settle\", \"lift\"]\n[boundary.motion]\nstage = \"lift\"\n"
      "displacement = [\"0\", \"0\", \"0.1*t\"]\n";
  const Ran ran = run(scene);
  double began_lift = 0, began_wait = 0;
  for (const auto& row : ran.history) {
    if (row.at("stage") >= 1 && began_lift == 0) began_lift = row.at("time");
    if (row.at("stage") >= 2 && began_wait == 0) began_wait = row.at("time");
  }
  CHECK(began_lift > 0.1);
  CHECK(began_lift < 2);  // at rest
  CHECK(began_wait - began_lift == Approx(0.1).margin(0.006));
  CHECK(ran.history.back().at("time") - began_wait == Approx(0.05).margin(0.006));
  for (const Snapshot& s : ran.snapshots) {
    const BoundaryRecord& lid = s.boundaries[1];
    if (s.time < began_lift - 0.006) CHECK(lid.point.z() == Approx(0.05));
    if (s.time > began_wait + 0.006) CHECK(lid.normal.isZero(0));
    if (s.time > began_lift + 0.006 && s.time < began_wait - 0.006) {
      CHECK(lid.point.z() == Approx(0.05 + 0.1 * (s.time - began_lift)).margin(6e-4));
    }
  }
  CHECK(ran.history.back().at("lid.force_z") == 0);
}

TEST_CASE("gravity follows its times and its formula") {
  const auto fallen = [](const std::string& gravity) {
    std::string scene = common + run_for + "0.1\n" + gravity +
                        "[filling]\nkind = \"lattice\"\nregion_min = [0, 0, 0.2]\nregion_max = [0.06, 0.06, 0.3]\n";
    const Ran ran = run(scene);
    return Vec3(ran.snapshots.back().position[0] - ran.snapshots.front().position[0]);
  };
  CHECK(fallen("[gravity]\nacceleration = [0, 0, -9.8]\nstart = 0.02\nend = 0.05\n").z() ==
        Approx(-0.5 * 9.8 * 0.03 * 0.03 - 9.8 * 0.03 * 0.05).epsilon(5e-3));
  const Vec3 d = fallen("[gravity]\nformula = [\"0.3*t\", \"0\", \"-2\"]\n");
  CHECK(d.x() == Approx(0.3 * std::pow(0.1, 3) / 6).epsilon(5e-3));
  CHECK(d.z() == Approx(-0.5 * 2 * 0.01).epsilon(5e-3));
  CHECK_THROWS_WITH(fallen("[gravity]\nformula = [\"t\"]\n"), Contains("three are needed"));
  CHECK_THROWS_WITH(fallen("[gravity]\nformula = [\"1/(t-0.05)\", \"0\", \"q\"]\n"), Contains("no formula in t"));
  CHECK_THROWS_WITH(fallen("[gravity]\nformula = [\"sqrt(0.05 - t)\", \"0\", \"0\"]\n"), Contains("not a number"));
}

TEST_CASE("stages that contradict themselves are refused") {
  const std::string rest = common + falls + "[filling]\nkind = \"random\"\n";
  CHECK_THROWS_WITH(run(rest + "[dynamics]\ntime_step = 2e-5\n"), Contains("needs duration"));
  CHECK_THROWS_WITH(run(rest + run_for + "3\n[[stage]]\nname = \"a\"\nduration = 1\n"),
                    Contains("not the stages' sum"));
  CHECK_THROWS_WITH(
      run(rest + "[dynamics]\n[[stage]]\nname = \"a\"\nduration = 1\n[[stage]]\nname = \"a\"\nduration = 1\n"),
      Contains("is taken"));
  CHECK_THROWS_WITH(run(rest + run_for +
                        "1\n[[boundary]]\nname = \"p\"\nkind = \"plane\"\npoint = [0,0,0]\n"
                        "normal = [0,0,1]\nstages = [\"a\"]\n"),
                    Contains("no stage \"a\""));
}
