// Runs of small scenes that go wrong: each is stopped with a verdict in parts, leaves the failing state marked, and
// runs through once the key that the verdict names is changed as it says.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "engine/dynamics/make_particles.hpp"
#include "engine/failing_state.hpp"
#include "engine/monitor.hpp"
#include "engine/run.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;
using packstone::testing::TemporaryFolder;

namespace {

/// Spheres from start.csv over a floor, or over what further says.
std::string spheres_scene(const std::string& further = R"([[boundary]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
)") {
  return R"(title = "Goes wrong"
[dynamics]
time_step = "20 us"
duration = "40 ms"
[domain]
min = [0, 0, 0]
max = [0.4, 0.4, 0.4]
open = ["z+"]
[gravity]
acceleration = [0, 0, -9.8]
[contact]
normal = "linear"
[[material]]
name = "glass"
density = 2500
normal_stiffness = 1e6
restitution = 0.5
[[particles]]
name = "balls"
material = "glass"
[filling]
kind = "file"
path = "start.csv"
[output]
interval = "5 ms"
history_interval = "1 ms"
fields = ["velocity"]
)" + further;
}

/// Particles that run into each other out of many, to be sure that the right ones are named.
const std::string bystanders = "0.05,0.05,0.02,0.02,0,0,0\n0.05,0.35,0.02,0.02,0,0,0\n0.35,0.05,0.02,0.02,0,0,0\n";

struct Trial {
  TemporaryFolder folder;
  std::string text;
  RunRecord record{};
  int runs = 0;

  explicit Trial(std::string scene, const std::string& spheres = "") : text(std::move(scene)) { start_from(spheres); }

  void start_from(const std::string& spheres) const {
    std::ofstream(folder / "start.csv") << "x,y,z,radius,vx,vy,vz\n" << spheres;
  }
  std::filesystem::path path() const { return folder / std::to_string(runs); }
  RunReader reader() const { return RunReader(path()); }
  const RunVerdict& verdict() const { return *record.failure; }

  bool passes(const std::vector<std::string>& set = {}) {
    ++runs;
    std::ofstream(folder / "scene.toml") << text;
    RunControl control;
    control.threads = 1;
    bool finished = true;
    std::string message;
    try {
      run_scene(read_scene(folder / "scene.toml", set), path(), control);
    } catch (const RunFailure& failure) {
      finished = false;
      message = failure.what();
    }
    record = reader().record();
    UNSCOPED_INFO(record.reason);
    CHECK(record.status == (finished ? RunStatus::finished : RunStatus::failed));
    CHECK(record.reason == message);
    CHECK(record.failure.has_value() == !finished);
    CHECK(std::filesystem::exists(path() / failing_state_name) == !finished);
    return finished;
  }

  /// With the value that the verdict's remedy at a place names.
  bool passes_with_remedy(std::size_t place = 0, std::vector<std::string> set = {}) {
    const Remedy remedy = verdict().remedies.at(place);
    REQUIRE_FALSE(remedy.value.empty());
    set.push_back(remedy.key + "=" + remedy.value);
    return passes(set);
  }
};

std::set<std::int64_t> ids(const std::vector<NamedParticle>& particles) {
  std::set<std::int64_t> result;
  for (const NamedParticle& p : particles) result.insert(p.id);
  return result;
}

std::set<std::int64_t> marked(const Snapshot& s, double mark) {
  std::set<std::int64_t> result;
  const std::vector<double>& values = s.fields.at(offender_field).values;
  for (std::size_t row = 0; row < s.size(); ++row) {
    if (values[row] == mark) result.insert(s.id[row]);
  }
  return result;
}

/// What holds of every failure.
void check_failure(const Trial& trial, FailureKind kind) {
  const RunVerdict& v = trial.verdict();
  INFO(trial.record.reason);
  CHECK(std::string(to_string(v.kind)) == to_string(kind));
  REQUIRE(v.time);
  REQUIRE(v.step);
  CHECK_THAT(v.message(), Contains(fmt::format("t = {:.6g} s, step {}: ", *v.time, *v.step)));
  CHECK(std::count(trial.record.reason.begin(), trial.record.reason.end(), '\n') == 0);
  CHECK_FALSE(v.quantity.empty());
  CHECK_FALSE((v.value <= v.limit && kind != FailureKind::filling_incomplete));  // not a number is beyond any
  for (const NamedParticle& p : v.particles) {
    if (p.group == "balls") CHECK_THAT(v.message(), Contains("(balls)"));
  }
  if (!v.particles.empty()) {
    CHECK_THAT(v.message(), Contains(told(v.particles.front())));
    CHECK(v.place.has_value());
  }
  REQUIRE_FALSE(v.remedies.empty());
  const RunReader run = trial.reader();
  for (std::size_t k = 0; k < run.snapshot_count(); ++k) {
    CHECK(run.snapshot(k).time <= *v.time * (1 + 1e-12));
    CHECK(run.snapshot_files()[k].parent_path().filename() == "snapshots");  // the failing state is not among them
  }
  const Snapshot state = read_snapshot(trial.path() / failing_state_name);
  CHECK(state.step == *v.step);
  CHECK(marked(state, 1) == ids(v.particles));
  CHECK(marked(state, 2) == ids(v.touching));
  CHECK_THAT(state.notes.at(0), Contains("run was stopped") && Contains(v.what));
  for (const Vec3& p : state.position) CHECK(p.allFinite());
}

}  // namespace

TEST_CASE("verdict: a contact beyond the overlap limit", "[verdict]") {
  Trial trial(spheres_scene(),
              bystanders + "0.2,0.2,0.1,0.02,0,0,-3\n0.2,0.2,0.02,0.02,0,0,0\n0.2,0.25,0.3,0.02,0,0,0\n");
  const std::vector<std::string> soft = {"material[0].normal_stiffness=1e4"};
  REQUIRE_FALSE(trial.passes(soft));
  check_failure(trial, FailureKind::overlap);
  CHECK(ids(trial.verdict().particles) == std::set<std::int64_t>{3, 4});
  CHECK(trial.verdict().boundaries == std::vector<std::string>{"floor"});  // on which the struck one lies
  CHECK((*trial.verdict().place - Vec3(0.2, 0.2, 0.04)).norm() < 0.002);
  CHECK(trial.verdict().limit == 0.05);
  CHECK(trial.verdict().value == Approx(0.05).epsilon(0.2));
  CHECK_THAT(trial.record.reason, Contains("monitor.overlap_limit = 5 %") && Contains("raise normal_stiffness"));
  const RunReader run = trial.reader();
  REQUIRE(run.snapshot_count() == static_cast<std::size_t>(*trial.verdict().time / 5e-3) + 1);
  REQUIRE(trial.verdict().remedies.front().key == "material[0].normal_stiffness");
  std::vector<std::string> kept;
  for (const auto& file : run.snapshot_files()) kept.push_back(read_text_file(file));
  CHECK(trial.passes({"material[0].normal_stiffness=1e6"}));
  trial.runs = 0;  // the run before is as it was
  for (std::size_t k = 0; k < kept.size(); ++k) CHECK((read_text_file(run.snapshot_files()[k]) == kept[k]));
}

TEST_CASE("verdict: a particle faster than half a radius a step", "[verdict]") {
  Trial trial(spheres_scene(), bystanders + "0.2,0.2,0.1,0.02,0,0,800\n");
  REQUIRE_FALSE(trial.passes({"dynamics.duration=5 ms"}));
  check_failure(trial, FailureKind::particle_too_fast);
  CHECK(ids(trial.verdict().particles) == std::set<std::int64_t>{3});
  CHECK(trial.verdict().value == Approx(0.8).epsilon(0.01));
  CHECK(trial.verdict().limit == 0.5);
  const Snapshot state = read_snapshot(trial.path() / failing_state_name);
  CHECK(state.fields.at("velocity").values[3 * state.rows_by_id().at(3) + 2] == Approx(800));
  CHECK(trial.passes_with_remedy(0, {"dynamics.duration=5 ms"}));
}

TEST_CASE("verdict: a particle lost through a closed face", "[verdict]") {
  Trial trial(spheres_scene(), bystanders + "0.2,0.2,0.3,0.02,0,0,8\n");
  const std::vector<std::string> closed = {"domain.open=[]"};
  REQUIRE_FALSE(trial.passes(closed));
  check_failure(trial, FailureKind::particle_lost);
  CHECK(ids(trial.verdict().particles) == std::set<std::int64_t>{3});
  CHECK(trial.verdict().place->z() > 0.4);
  CHECK(trial.verdict().value == Approx(trial.verdict().place->z() - 0.4));
  CHECK_THAT(trial.record.reason, Contains("through the face z+") && Contains("domain.open"));
  CHECK(trial.passes_with_remedy(0, closed));
}

TEST_CASE("verdict: a particle gone for good through an open face", "[verdict]") {
  Trial trial(spheres_scene(), bystanders + "0.2,0.2,0.3,0.02,0,0,30\n");
  REQUIRE_FALSE(trial.passes({"gravity.acceleration=[9.8, 0, 0]"}));
  check_failure(trial, FailureKind::particle_lost);
  CHECK(trial.verdict().limit == Approx(0.4));
  CHECK_THAT(trial.record.reason, Contains("nothing pulls it back"));
  trial.text += "[[boundary]]\nname = \"lid\"\nkind = \"plane\"\npoint = [0, 0, 0.4]\nnormal = [0, 0, -1]\n";
  CHECK(trial.passes({"gravity.acceleration=[9.8, 0, 0]", "monitor.overlap_limit=0.5"}));
}

TEST_CASE("verdict: a particle pressed through a thin wall", "[verdict]") {
  const std::string plate =
      "[[boundary]]\nname = \"plate\"\nkind = \"polygons\"\n"
      "polygons = [[[0,0,0.1],[0.4,0,0.1],[0.4,0.4,0.1],[0,0.4,0.1]]]\n";
  Trial trial(spheres_scene(plate), "0.1,0.1,0.2,0.02,0,0,0\n0.2,0.2,0.2,0.02,0,0,-10\n");
  const std::vector<std::string> soft = {"material[0].normal_stiffness=1e3", "monitor.overlap_limit=1"};
  REQUIRE_FALSE(trial.passes(soft));
  check_failure(trial, FailureKind::wall_crossed);
  CHECK(ids(trial.verdict().particles) == std::set<std::int64_t>{1});
  CHECK(trial.verdict().boundaries == std::vector<std::string>{"plate"});
  CHECK(trial.verdict().place->z() < 0.1);
  CHECK(trial.verdict().place->z() > 0.08);  // no farther than a step before
  REQUIRE(trial.verdict().remedies.front().key == "material[0].normal_stiffness");
  CHECK(trial.passes({"material[0].normal_stiffness=1e6", "monitor.overlap_limit=1"}));
  // With the usual limit it is stopped long before.
  REQUIRE_FALSE(trial.passes({"material[0].normal_stiffness=1e3"}));
  check_failure(trial, FailureKind::overlap);
  CHECK(trial.verdict().boundaries == std::vector<std::string>{"plate"});
}

TEST_CASE("verdict: nothing goes through a thin wall unseen", "[verdict]") {
  // From crawling to three radii a step, at an angle, beginning at any part of a step.
  const std::string plate =
      "[[boundary]]\nname = \"plate\"\nkind = \"polygons\"\n"
      "polygons = [[[-1,-1,0.1],[1,-1,0.1],[1,1,0.1],[-1,1,0.1]]]\n";
  int stopped = 0, bounced = 0;
  for (const double way : {0.05, 0.2, 0.45, 0.49, 0.51, 0.7, 1.0, 1.6, 2.3, 3.0}) {
    for (const double part : {0.0, 0.3, 0.7}) {
      const double speed = way * 0.02 / 20e-6;
      Trial trial(spheres_scene(plate),
                  fmt::format("0.2,0.2,{},0.02,{},0,{}\n", 0.16 + part * way * 0.02, 0.2 * speed, -speed));
      const bool passed =
          trial.passes({fmt::format("dynamics.duration={}", 0.08 / speed), "output.interval=20 us",
                        "output.history_interval=20 us", "monitor.overlap_limit=1", "gravity.start=1",
                        "material[0].normal_stiffness=1e7", "domain.min=[-1, -1, -1]", "domain.max=[1, 1, 1]"});
      ++(passed ? bounced : stopped);
      const RunReader run = trial.reader();
      for (std::size_t k = 0; k < run.snapshot_count(); ++k) CHECK(run.snapshot(k).position.at(0).z() > 0.1);
    }
  }
  CHECK(stopped >= 18);
  CHECK(bounced >= 6);
}

TEST_CASE("verdict: a boundary that goes too far in a step", "[verdict]") {
  Trial trial(spheres_scene("[[boundary]]\nname = \"ram\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                            "[boundary.motion]\ndisplacement = [\"0\", \"0\", \"-700*t\"]\n"),
              bystanders);
  REQUIRE_FALSE(trial.passes({"dynamics.duration=5 ms"}));
  check_failure(trial, FailureKind::boundary_too_fast);
  CHECK(trial.verdict().boundaries == std::vector<std::string>{"ram"});
  CHECK(trial.verdict().value == Approx(0.7));
  CHECK(trial.passes_with_remedy(0, {"dynamics.duration=5 ms"}));
}

TEST_CASE("verdict: positions that are no numbers", "[verdict]") {
  const std::string same_place = "0.2,0.2,0.3,0.02,0,0,0\n0.2,0.2,0.3,0.02,0,0,0\n0.23,0.2,0.3,0.02,0,0,0\n";
  Trial trial(spheres_scene(), bystanders + same_place);
  REQUIRE_FALSE(trial.passes({"monitor.overlap_limit=1"}));
  check_failure(trial, FailureKind::not_a_number);
  CHECK(ids(trial.verdict().particles) == std::set<std::int64_t>{3, 4});
  CHECK(ids(trial.verdict().touching) == std::set<std::int64_t>{5});
  CHECK((*trial.verdict().place - Vec3(0.2, 0.2, 0.3)).norm() < 1e-6);
  CHECK_THAT(trial.record.reason,
             Contains("its centre lay where that of particle 4 does") && Contains("start.csv (filling.path)"));
  trial.start_from(bystanders + "0.2,0.2,0.25,0.02,0,0,0\n0.2,0.2,0.3,0.02,0,0,0\n0.25,0.2,0.3,0.02,0,0,0\n");
  CHECK(trial.passes({"monitor.overlap_limit=1"}));
}

TEST_CASE("verdict: a failing state without numbers can be read, looked at and tells where they went", "[verdict]") {
  const Scene scene = parse_scene(spheres_scene(), "s.toml");
  const std::vector<Vec3> places = {Vec3(0.1, 0.1, 0.1), Vec3(0.2, 0.1, 0.1), Vec3(0.3, 0.1, 0.1)};
  StartingState start;
  start.position = places;
  start.velocity = start.angular_velocity = std::vector<Vec3>(3, Vec3::Zero());
  start.radius.assign(3, 0.02);
  start.type.assign(3, 0);
  Particles particles = make_particles(scene, start);
  particles.next.rows = particles.now.rows;
  particles.now.rows[1].position.y() = std::nan("");
  particles.now.rows[2].position.setConstant(INFINITY);
  particles.next.rows[2].position.setConstant(std::nan(""));
  const Domain domain = scene.box();
  const Boundaries boundaries(scene, domain);
  const FailingState state{scene, domain, particles, boundaries, 1, true};
  RunVerdict verdict{FailureKind::not_a_number};
  try {
    Monitor(scene, domain, 1e-5, 1e-5, 0).check_positions(particles, 0.5);
    FAIL("no failure");
  } catch (const RunFailure& failure) {
    verdict = failure.verdict();
  }
  state.name_contacts(verdict);
  CHECK(ids(verdict.particles) == std::set<std::int64_t>{1, 2});
  CHECK(*verdict.place == places[1]);
  Snapshot snapshot;
  snapshot.domain = domain;
  snapshot.id = {0, 1, 2};
  snapshot.position = {particles.now.rows[0].position, particles.now.rows[1].position, particles.now.rows[2].position};
  snapshot.radius.assign(3, 0.02);
  snapshot.type = snapshot.material = {0, 0, 0};
  snapshot.material_names = {"glass"};
  snapshot.groups = {{"balls", "glass", 2500}};
  state.mark(snapshot, verdict);
  const TemporaryFolder folder;
  write_snapshot(folder / "s.vtkhdf", snapshot);
  const Snapshot read = read_snapshot(folder / "s.vtkhdf");
  REQUIRE(read.size() == 2);
  const auto rows = read.rows_by_id();
  CHECK(read.position[rows.at(0)] == places[0]);
  CHECK(read.position[rows.at(1)] == places[1]);
  CHECK(marked(read, 1) == std::set<std::int64_t>{1});
  REQUIRE(read.notes.size() == 3);
  CHECK_THAT(read.notes[1], Contains("particle 1") && Contains("shown where it was a step before"));
  CHECK_THAT(read.notes[2], Contains("particle 2") && Contains("left out"));
}

TEST_CASE("verdict: energy that nothing puts in", "[verdict]") {
  // Springs without damping at a step just below a single contact's limit: a sphere between two others is beyond its
  // own. The limit is 2 sqrt(m_eff/k) = 410 us, that of a long row 290 us.
  std::string row;
  for (int k = 0; k < 10; ++k) row += fmt::format("0.2,0.2,{},0.02,0,0,{}\n", 0.0199 + 0.0397 * k, k == 9 ? -0.2 : 0.0);
  Trial trial(spheres_scene(), bystanders + row);
  const std::vector<std::string> set = {"material[0].restitution=1", "dynamics.time_step=380 us",
                                        "monitor.overlap_limit=1", "dynamics.duration=0.2"};
  REQUIRE_FALSE(trial.passes(set));
  check_failure(trial, FailureKind::energy_growth);
  CHECK(trial.verdict().particles.size() == 3);
  for (const std::int64_t id : ids(trial.verdict().particles)) CHECK(id >= 3);  // none of the bystanders
  CHECK_THAT(trial.record.reason, Contains("the energy grows") && Contains("of the kinetic energy"));
  REQUIRE(trial.verdict().remedies.front().key == "dynamics.time_step");
  CHECK(trial.passes_with_remedy(0, {"material[0].restitution=1", "monitor.overlap_limit=1", "dynamics.duration=0.2"}));
}

TEST_CASE("verdict: an account that does not close is told, from 2 % on", "[verdict]") {
  // A collision in so few steps that what damping takes is not what the account says.
  Trial trial(spheres_scene(), bystanders + "0.2,0.2,0.021,0.02,0,0,-1\n");
  const std::vector<std::string> coarse = {"dynamics.time_step=150 us", "material[0].restitution=0.3",
                                           "gravity.start=1", "monitor.overlap_limit=1"};
  REQUIRE(trial.passes(coarse));
  REQUIRE(trial.record.doubts.size() == 1);
  const RunVerdict& doubt = trial.record.doubts.front();
  CHECK(doubt.kind == FailureKind::account_open);
  CHECK(std::abs(doubt.value) > doubt.limit);
  CHECK(std::count(trial.record.warnings.begin(), trial.record.warnings.end(), doubt.message()) == 1);
  const History history = trial.reader().history();
  CHECK(doubt.value == Approx(history.column("energy_error").back()));
  REQUIRE(doubt.remedies.front().key == "dynamics.time_step");
  CHECK(trial.passes({"dynamics.time_step=" + doubt.remedies.front().value, "material[0].restitution=0.3",
                      "gravity.start=1", "monitor.overlap_limit=1"}));
  CHECK(trial.record.doubts.empty());
}

TEST_CASE("verdict: formulas that give no number", "[verdict]") {
  SECTION("of gravity") {
    Trial trial(spheres_scene(), bystanders);
    const std::vector<std::string> set = {"gravity.formula=[\"0\", \"0\", \"-9.8*sqrt(0.0105-t)\"]"};
    REQUIRE_FALSE(trial.passes(set));
    check_failure(trial, FailureKind::formula_not_a_number);
    CHECK(*trial.verdict().time == Approx(0.0105).margin(2.1e-5));
    CHECK(trial.passes_with_remedy(1, set));
  }
  SECTION("of a motion") {
    Trial trial(spheres_scene("[[boundary]]\nname = \"ram\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                              "[boundary.motion]\ndisplacement = [\"0\", \"0\", \"-0.001*sqrt(0.0105-t)\"]\n"),
                bystanders);
    REQUIRE_FALSE(trial.passes());
    check_failure(trial, FailureKind::formula_not_a_number);
    CHECK(trial.verdict().boundaries == std::vector<std::string>{"ram"});
    REQUIRE(trial.verdict().remedies.at(1).key == "boundary[0].motion.end");
    CHECK(trial.passes({"boundary[0].motion.end=0.01"}));
  }
}

TEST_CASE("verdict: a filling that does not get in", "[verdict]") {
  std::string text = spheres_scene();
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("kind = \"file\"\npath = \"start.csv\"",
          "kind = \"pour\"\nrate = 100\nregion_min = [0.1, 0.1, 0.3]\nregion_max = [0.15, 0.15, 0.36]");
  replace("material = \"glass\"\n[filling]", "material = \"glass\"\ncount = 4\nradius = 0.02\n[filling]");
  Trial trial(text);
  const std::string periodic = "domain.periodic=[\"x\", \"y\"]";  // nothing rolls off
  REQUIRE_FALSE(trial.passes({"dynamics.duration=0.1", periodic}));
  check_failure(trial, FailureKind::filling_incomplete);
  CHECK(trial.verdict().limit == 4);
  REQUIRE(trial.verdict().remedies.front().key == "dynamics.duration");
  CHECK(trial.passes({"dynamics.duration=0.6", periodic}));
}

TEST_CASE("verdict: overdamped motion beyond what its integrator can follow", "[verdict]") {
  std::string text = spheres_scene();
  text.replace(text.find("time_step = \"20 us\""), std::string("time_step = \"20 us\"").size(),
               "kind = \"overdamped\"\nviscosity = 4");
  text.replace(text.find("restitution = 0.5\n"), std::string("restitution = 0.5\n").size(), "");
  std::string bed;  // columns of five on the floor, pressed a little
  for (int k = 0; k < 5; ++k) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        bed += fmt::format("{},{},{},0.02,0,0,0\n", 0.1 + 0.0398 * a, 0.1 + 0.0398 * b, 0.0199 + 0.0398 * k);
      }
    }
  }
  SECTION("instability") {
    // mu/k = 0.4 ms; contacts on all sides leave explicit Euler 2/12 of it at the worst.
    Trial trial(text, bed);
    const std::vector<std::string> set = {"material[0].normal_stiffness=1e4", "dynamics.integrator=euler",
                                          "monitor.overlap_limit=1", "dynamics.duration=0.2"};
    std::vector<std::string> long_steps = set;
    long_steps.push_back("dynamics.time_step=0.25 ms");
    REQUIRE_FALSE(trial.passes(long_steps));
    check_failure(trial, FailureKind::overdamped_instability);
    CHECK_FALSE(trial.verdict().particles.empty());
    CHECK(trial.passes_with_remedy(0, set));
  }
  SECTION("a given step in which a particle goes too far") {
    // From the start of gravity on, between two looks.
    Trial trial(text, "0.1,0.1,0.3,0.02,0,0,0\n0.2,0.2,0.3,0.01,0,0,0\n");
    const std::vector<std::string> set = {"material[0].normal_stiffness=1e4",   "monitor.overlap_limit=1",
                                          "dynamics.integrator=euler",          "gravity.start=10.4 ms",
                                          "gravity.acceleration=[0, 0, -1500]", "dynamics.duration=15 ms"};
    std::vector<std::string> long_steps = set;
    long_steps.push_back("dynamics.time_step=0.38 ms");
    REQUIRE_FALSE(trial.passes(long_steps));
    check_failure(trial, FailureKind::step_too_long);
    CHECK(trial.verdict().particles.size() == 1);
    CHECK(trial.verdict().particles.front().id == 0);  // the heavier
    CHECK(trial.passes_with_remedy(0, set));
  }
}

TEST_CASE("verdict: a bed that does not come to rest in its time", "[verdict]") {
  Trial trial(spheres_scene(), bystanders + "0.2,0.2,0.3,0.02,0,0,0\n");
  const std::vector<std::string> set = {"dynamics.goal=rest", "dynamics.time_step=auto", "monitor.overlap_limit=0.5"};
  std::vector<std::string> soon = set;
  soon.push_back("dynamics.duration=0.05");
  REQUIRE_FALSE(trial.passes(soon));
  check_failure(trial, FailureKind::non_convergence);
  REQUIRE(trial.verdict().remedies.front().key == "dynamics.duration");
  std::vector<std::string> later = set;
  later.push_back("dynamics.duration=4");
  const bool passed = trial.passes(later);
  INFO(trial.record.reason);
  CHECK(passed);
}

TEST_CASE("verdict: as run.json holds it, it comes back", "[verdict]") {
  const TemporaryFolder folder;
  RunVerdict v{FailureKind::not_a_number};
  v.time = 0.5;
  v.step = 7;
  v.particles = {{17, "balls"}, {3, "größer"}};
  v.touching = {{9, "balls"}};
  v.boundaries = {"floor"};
  v.place = Vec3(1e-3, -2, 1.0 / 3);
  v.quantity = "position";
  v.value = std::nan("");
  v.limit = 0.25;
  v.unit = "m";
  v.what = "it is \"wrong\"";
  v.cause = "why";
  v.advice = "so";
  v.remedies = {{"dynamics.time_step", "1 us"}, {"filling.path"}};
  RunRecord record;
  record.failure = v;
  record.doubts = {v, v};
  RunWriter(folder / "run", false).write_record(record);
  const RunRecord read = RunReader(folder / "run").record();
  REQUIRE(read.failure);
  CHECK(read.doubts.size() == 2);
  CHECK(read.failure->message() == v.message());
  CHECK(read.failure->particles == v.particles);
  CHECK(read.failure->touching == v.touching);
  CHECK(read.failure->remedies == v.remedies);
  CHECK(read.failure->boundaries == v.boundaries);
  CHECK(*read.failure->place == *v.place);
  CHECK(std::isnan(read.failure->value));
  CHECK(read.failure->limit == 0.25);
  CHECK(v.message() == "t = 0.5 s, step 7: it is \"wrong\"; in contact with 9 (balls); why; so");
}
