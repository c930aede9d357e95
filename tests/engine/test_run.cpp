// A scene run into a folder: what is written, and that it never depends on threads.
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/checkpoints.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "engine/run.hpp"
#include "engine/simulation.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;
using packstone::testing::small_scene;

namespace {

const std::vector<std::string> with_friction = {"contact.tangential=cundall-strack",
                                                "material[0].tangential_stiffness=1e6",
                                                "material[1].tangential_stiffness=1e6",
                                                "material[0].friction=0.4",
                                                "material[1].friction=0.4",
                                                "output.fields=[\"velocity\", \"angular_velocity\", \"force\"]"};

std::vector<std::string> in_mixed_precision(std::vector<std::string> set) {
  set.push_back("dynamics.precision=mixed");
  return set;
}

RunRecord run_into(const std::filesystem::path& folder, const std::vector<std::string>& set, int threads) {
  RunControl control;
  control.threads = threads;
  return run_scene(parse_scene(small_scene, "s.toml", set), folder, control);
}

}  // namespace

TEST_CASE("one, two and three threads write the same bytes") {
  const std::vector<std::string> set =
      GENERATE(std::vector<std::string>{}, with_friction, in_mixed_precision({}), in_mixed_precision(with_friction));
  // Enough particles to be worth three threads.
  std::vector<std::string> many = {"particles[0].count=900", "particles[1].count=900", "particles[0].radius=0.008",
                                   "particles[1].radius=0.008", "dynamics.duration=50 ms"};
  many.insert(many.end(), set.begin(), set.end());
  const packstone::testing::TemporaryFolder folder;
  for (int threads : {1, 2, 3}) run_into(folder / std::to_string(threads), many, threads);
  const RunReader one(folder / "1");
  REQUIRE(one.snapshot_count() == 4);
  REQUIRE(one.snapshot(3).contacts->size() > 5);
  for (const auto& file : one.snapshot_files()) {
    const std::string name = "snapshots/" + file.filename().string();
    const std::string bytes = read_text_file(file);
    CHECK((bytes == read_text_file(folder / ("2/" + name))));
    CHECK((bytes == read_text_file(folder / ("3/" + name))));
  }
  CHECK(read_text_file(folder / "1/history.csv") == read_text_file(folder / "2/history.csv"));
}

TEST_CASE("how often a run is recorded does not change it") {
  // Alike particles take a way of their own through the steps that are not recorded.
  std::vector<std::string> alike = with_friction;
  alike.insert(alike.end(), {"particles[1].material=light", "contact.normal=linear", "monitor.overlap_limit=0.5"});
  const std::vector<std::string> set = GENERATE_COPY(std::vector<std::string>{}, with_friction, alike,
                                                     in_mixed_precision(with_friction), in_mixed_precision(alike));
  std::vector<std::string> often = set, seldom = set;
  often.push_back("output.history_interval=0.1 ms");
  seldom.push_back("output.history_interval=20 ms");
  const packstone::testing::TemporaryFolder folder;
  run_into(folder / "often", often, 1);
  run_into(folder / "seldom", seldom, 1);
  const Snapshot a = RunReader(folder / "often").snapshot(4), b = RunReader(folder / "seldom").snapshot(4);
  REQUIRE(a.id == b.id);
  CHECK(a.position == b.position);
  CHECK(a.fields.at("velocity").values == b.fields.at("velocity").values);
}

TEST_CASE("a run in mixed precision ends where one in double precision does") {
  // Long enough to fall and settle: paths part, measures must not.
  const std::vector<std::string> set = GENERATE(std::vector<std::string>{}, with_friction);
  const packstone::testing::TemporaryFolder folder;
  run_into(folder / "double", set, 1);
  run_into(folder / "mixed", in_mixed_precision(set), 1);
  const History a = RunReader(folder / "double").history(), b = RunReader(folder / "mixed").history();
  const auto last = [](const History& t, const char* column) { return t.column(column).back(); };
  CHECK(last(a, "dissipated") != last(b, "dissipated"));
  for (const char* energy : {"gravitational", "dissipated", "growth_work", "gravity_work"}) {
    CHECK(last(a, energy) == Approx(last(b, energy)).epsilon(0.01));
  }
  const Snapshot end = RunReader(folder / "mixed").snapshot(4);
  REQUIRE(end.contacts->size() > 2);
  for (std::size_t c = 0; c < end.contacts->size(); ++c) {
    const auto first =
        static_cast<std::size_t>(std::find(end.id.begin(), end.id.end(), end.contacts->first[c]) - end.id.begin());
    const double lever = end.domain.separation(end.contacts->point[c], end.position[first]).norm();
    CHECK(lever == Approx(end.radius[first] - 0.5 * end.contacts->overlap[c]).epsilon(1e-6));
  }
  CHECK(last(a, "packing_fraction") == Approx(last(b, "packing_fraction")).margin(0.005));
}

TEST_CASE("mixed precision warns where a sphere's weight is lost in it") {
  const auto warnings = [](const char* stiffness) {
    return Simulation(parse_scene(small_scene, "s.toml",
                                  {"dynamics.precision=mixed", "dynamics.time_step=1 us",
                                   "material[0].normal_stiffness=" + std::string(stiffness),
                                   "material[1].normal_stiffness=" + std::string(stiffness)}))
        .warnings();
  };
  const auto of_precision = [](const std::string& warning) { return warning.starts_with("dynamics.precision"); };
  const std::vector<std::string> soft = warnings("1e5"), hard = warnings("1e8");
  CHECK(std::none_of(soft.begin(), soft.end(), of_precision));
  CHECK(std::any_of(hard.begin(), hard.end(), of_precision));
}

TEST_CASE("the run folder holds the run") {
  const packstone::testing::TemporaryFolder folder;
  const RunRecord record = run_into(folder / "run", with_friction, 2);
  CHECK(record.status == RunStatus::finished);
  CHECK(record.steps == 4000);
  const RunReader run(folder / "run");
  CHECK(run.record().status == RunStatus::finished);
  CHECK(run.record().particles == 120);
  CHECK(run.times().size() == 5);
  CHECK(run.history().rows() == 81);
  CHECK(scene_hash(parse_scene(run.scene_text(), "scene.toml")) == run.record().scene_hash);
  const Snapshot s = run.snapshot(4);
  CHECK(s.size() == 120);
  CHECK(s.radius[0] == 0.02);
  CHECK(run.snapshot(1).radius[0] == Approx(0.01));
  CHECK(s.fields.count("angular_velocity") == 1);
  REQUIRE(s.contacts);
  const History history = run.history();
  CHECK(s.contacts->size() > 0);
  CHECK(static_cast<double>(s.contacts->size()) ==
        history.column("contacts").back() + history.column("wall_contacts").back());
  CHECK(s.scene_hash == run.record().scene_hash);
  // Contacts are where the geometry says they are.
  const auto row = s.rows_by_id();
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    if (s.contacts->second[k] < 0) continue;
    const auto i = row.at(s.contacts->first[k]), j = row.at(s.contacts->second[k]);
    const double distance = s.domain.separation(s.position[i], s.position[j]).norm();
    CHECK(s.contacts->overlap[k] == Approx(s.radius[i] + s.radius[j] - distance).margin(1e-12));
  }
}

TEST_CASE("a snapshot's forces are those of its contacts and gravity") {
  const packstone::testing::TemporaryFolder folder;
  run_into(folder / "run", with_friction, 1);
  const Snapshot s = RunReader(folder / "run").snapshot(4);
  const auto row = s.rows_by_id();
  std::vector<Vec3> sum(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) sum[i] = s.mass(i) * s.gravity;
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    sum[row.at(s.contacts->first[k])] += s.contacts->force[k];
    if (s.contacts->second[k] >= 0) sum[row.at(s.contacts->second[k])] -= s.contacts->force[k];
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Eigen::Map<const Vec3> force(&s.fields.at("force").values[3 * i]);
    CHECK((sum[i] - force).norm() < 1e-9 * (1 + force.norm()));
  }
}

TEST_CASE("an interrupted run keeps what it has and says so") {
  const packstone::testing::TemporaryFolder folder;
  RunControl control;
  int asked = 0;
  control.should_stop = [&] { return ++asked > 700; };
  CHECK_THROWS_AS(run_scene(parse_scene(small_scene, "s.toml"), folder / "run", control), Interrupted);
  const RunReader run(folder / "run");
  CHECK(run.record().status == RunStatus::interrupted);
  CHECK(run.record().steps == 700);
  CHECK(run.times() == std::vector<double>{0});  // nothing that one never stopped would not have
  CHECK(run.history().column("time").back() == Approx(0.013));
  CHECK(Checkpoints::newest(Checkpoints(folder / "run").find())->head.moment.step == 700);
}

TEST_CASE("a failed run says why and keeps its snapshots") {
  const packstone::testing::TemporaryFolder folder;
  CHECK_THROWS_AS(run_into(folder / "run", {"gravity.acceleration=[0, 0, 5000]", "dynamics.duration=1 s"}, 1),
                  RunError);
  const RunReader run(folder / "run");
  CHECK(run.record().status == RunStatus::failed);
  CHECK_THAT(run.record().reason, Contains("nothing pulls it back"));
  CHECK(run.snapshot(run.snapshot_count() - 1).size() == 120);
}

TEST_CASE("a scene that is refused leaves no folder") {
  const packstone::testing::TemporaryFolder folder;
  CHECK_THROWS_AS(run_into(folder / "run", {"dynamics.time_step=1 ms"}, 1), InputError);
  CHECK_THROWS_AS(run_into(folder / "run", {"particles[0].count=1000"}, 1), InputError);
  CHECK_THROWS_AS(run_into(folder / "run", {"domain.max=[0.08, 0.2, 2]", "particles[0].count=1"}, 1), InputError);
  CHECK_THROWS_AS(run_into(folder / "run", {"output.interval=1 us"}, 1), InputError);
  CHECK_FALSE(std::filesystem::exists(folder / "run"));
}
