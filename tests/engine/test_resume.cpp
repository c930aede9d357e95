// A run that was stopped and goes on leaves the same bytes as one that never was: for every law, filling, motion of a
// boundary and integrator.
#include <algorithm>
#include <fstream>
#include <limits>
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "core/checkpoints.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "core/run_folder_state.hpp"
#include "core/scene_checks.hpp"
#include "engine/earlier_run.hpp"
#include "engine/run.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;
using packstone::testing::file_scene;
using packstone::testing::small_scene;
using packstone::testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

/// Where a checkpoint need not wait for a disk.
fs::path memory() { return fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path(); }

/// Runs until it has been asked so often whether to stop; returns how often it was.
std::int64_t run_until(const Scene& scene, const fs::path& folder, std::int64_t asked_at_most, int threads,
                       bool resume) {
  RunControl control;
  control.threads = threads;
  control.resume = resume;
  std::int64_t asked = 0;
  control.should_stop = [&] { return ++asked > asked_at_most; };
  try {
    run_scene(scene, folder, control);
  } catch (const Interrupted&) {
    REQUIRE(asked > asked_at_most);
  }
  return asked;
}

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

std::string last_checkpoint(const fs::path& folder) {
  const auto found = Checkpoints::newest(Checkpoints(folder).find());
  REQUIRE(found);
  return read_text_file(found->file);
}

void check_same_bytes(const fs::path& whole, const fs::path& stopped) {
  const auto files = snapshot_files(whole), others = snapshot_files(stopped);
  REQUIRE(files.size() == others.size());
  for (std::size_t k = 0; k < files.size(); ++k) {
    INFO(files[k].filename());
    CHECK(files[k].filename() == others[k].filename());
    CHECK((read_text_file(files[k]) == read_text_file(others[k])));
  }
  for (const char* file : {"history.csv", "scene.toml", "snapshots/snapshots.vtkhdf.series"}) {
    INFO(file);
    CHECK((read_text_file(whole / file) == read_text_file(stopped / file)));
  }
  CHECK((last_checkpoint(whole) == last_checkpoint(stopped)));
  const RunRecord a = read_record(whole), b = read_record(stopped);
  CHECK(b.status == RunStatus::finished);
  CHECK(a.steps == b.steps);
  CHECK(a.list_builds == b.list_builds);
  CHECK(a.integrator_steps == b.integrator_steps);
  CHECK(a.particles == b.particles);
  CHECK(a.warnings == b.warnings);
  CHECK(a.ending == b.ending);
  CHECK(a.filling_hash == b.filling_hash);
}

/// Stops a run at random moments, goes on with one and two threads in turn, and compares. Returns the whole run's
/// history.
History check_resumed(const std::string& name, const std::string& text, const std::vector<std::string>& set = {},
                      int stops = 2) {
  INFO(name);
  const TemporaryFolder folder(memory());
  const Scene scene = parse_scene(text, name, set);
  const fs::path whole = folder / "whole", stopped = folder / "stopped";
  const std::int64_t all = run_until(scene, whole, never, 1, false);
  std::mt19937 random(static_cast<std::uint32_t>(std::hash<std::string>{}(name)));
  std::int64_t left = all;
  for (int k = 0; k <= stops; ++k) {
    const std::int64_t most = k == stops ? never : std::uniform_int_distribution<std::int64_t>(1, left - 1)(random);
    left = std::max<std::int64_t>(2, left - most);
    run_until(scene, stopped, most, 1 + k % 2, k > 0);
  }
  check_same_bytes(whole, stopped);
  return RunReader(whole).history();
}

/// Spheres of two sizes over a floor under strong gravity. The keys are those of all laws.
std::string falling_scene(const std::string& contact, const std::string& material, const std::string& filling,
                          const std::string& more = "") {
  return fmt::format(R"(
[dynamics]
duration = 0.1
[domain]
min = [0, 0, -0.05]
max = [0.15, 0.15, 0.4]
periodic = ["x", "y"]
open = ["z+"]
[gravity]
acceleration = [0, 0, -40]
[contact]
{}
[[material]]
name = "m"
density = 2500
normal_stiffness = 1e5
tangential_stiffness = 8e4
tangential_damping = 5
young_modulus = 5e6
poisson_ratio = 0.3
{}
[[particles]]
name = "large"
material = "m"
count = 20
radius = 0.02
[[particles]]
name = "small"
material = "m"
count = 40
radius = 0.012
[filling]
{}
[[boundary]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
{}
[output]
interval = 0.03
history_interval = 0.004
fields = ["velocity", "angular_velocity", "force"]
[monitor]
overlap_limit = 0.9
energy_tolerance = 5
)",
                     contact, material, filling, more);
}

const std::string random_places = "kind = \"random\"\nregion_min = [0, 0, 0]\nregion_max = [0.15, 0.15, 0.2]";
const std::string linear_with_springs = "normal = \"linear\"\ntangential = \"cundall-strack\"";
const std::string rough = "restitution = 0.5\nfriction = 0.4";

/// Spheres that sink in oil.
std::string sinking_scene(const std::string& dynamics, const std::string& contact = "normal = \"linear\"",
                          const std::string& more = "") {
  return fmt::format(R"(
[dynamics]
kind = "overdamped"
viscosity = 3.7
{}
[domain]
min = [0, 0, 0]
max = [0.12, 0.12, 0.25]
periodic = ["x", "y"]
open = ["z+"]
[gravity]
[contact]
{}
[[material]]
name = "m"
density = 2500
normal_stiffness = 1e4
young_modulus = 1e6
poisson_ratio = 0.3
[[particles]]
material = "m"
count = 80
radius = 0.01
[filling]
kind = "random"
region_max = [0.12, 0.12, 0.1]
[[boundary]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
{}
[output]
interval = 0.2
history_interval = 0.1
)",
                     dynamics, contact, more);
}

std::string in_motion(const std::string& motion) { return "[boundary.motion]\n" + motion; }

}  // namespace

TEST_CASE("a run goes on bit for bit with every normal and tangential law", "[resume]") {
  for (const std::string& normal : normal_laws) {
    const std::string loss = normal == "kuwabara-kono" ? "dissipation_time = 1e-5" : "restitution = 0.5";
    for (const std::string& tangential : tangential_laws) {
      const std::string name = normal + " with " + tangential;
      const History history =
          check_resumed(name, falling_scene("normal = \"" + normal + "\"\ntangential = \"" + tangential + "\"",
                                            loss + (tangential == "none" ? "" : "\nfriction = 0.4"), random_places));
      INFO(name);
      CHECK(history.column("contacts").back() > 5);
      CHECK(history.column("wall_contacts").back() > 2);
    }
  }
}

TEST_CASE("a run goes on bit for bit with attraction, mixed precision and either velocity", "[resume]") {
  const std::string attraction = "[contact.van_der_waals]\nhamaker = 1e-5\nmin_gap = 1e-5\n";
  check_resumed("attraction", falling_scene("normal = \"linear\"\n" + attraction, "restitution = 0.5", random_places));
  const std::string springs = falling_scene(linear_with_springs, rough, random_places);
  check_resumed("mixed, springs", springs, {"dynamics.precision=mixed"});
  check_resumed("mixed, plastic", falling_scene("normal = \"walton-braun\"", "restitution = 0.5", random_places),
                {"dynamics.precision=mixed"});
  for (const char* velocity : {"step", "half-step"}) {
    check_resumed(std::string("velocity of the ") + velocity, springs,
                  {std::string("dynamics.contact_velocity=") + velocity});
  }
}

TEST_CASE("a run of particles enough for two threads goes on bit for bit", "[resume]") {
  const std::string precision = GENERATE("double", "mixed");
  check_resumed("many, " + precision, small_scene,
                {"particles[0].count=900", "particles[1].count=900", "particles[0].radius=0.008",
                 "particles[1].radius=0.008", "dynamics.duration=50 ms", "contact.tangential=cundall-strack",
                 "material[0].tangential_stiffness=1e6", "material[1].tangential_stiffness=1e6",
                 "material[0].friction=0.4", "material[1].friction=0.4", "dynamics.precision=" + precision});
}

TEST_CASE("a run goes on bit for bit with every filling", "[resume]") {
  check_resumed("growth", small_scene);
  check_resumed("lattice",
                falling_scene(linear_with_springs, rough, "kind = \"lattice\"\nlattice = \"cubic\"\nspacing = 0.042"));
  const std::string poured = "kind = \"pour\"\nregion_min = [0, 0, 0.1]\nregion_max = [0.15, 0.15, 0.35]\n";
  check_resumed("poured at a rate", falling_scene(linear_with_springs, rough, poured + "rate = 800"), {}, 4);
  check_resumed("poured in portions",
                falling_scene(linear_with_springs, "restitution = 0.1\nfriction = 0.4",
                              poured + "portions = 2\nrest_speed = 0.3"),
                {"dynamics.duration=0.6"}, 4);
}

TEST_CASE("a run from a file goes on without it", "[resume]") {
  const TemporaryFolder folder(memory());
  run_until(parse_scene(small_scene, "source"), folder / "source", never, 1, false);
  fs::copy(snapshot_files(folder / "source").back(), folder / "start.vtkhdf");
  const Scene scene = parse_scene(file_scene((folder / "start.vtkhdf").string()), "file");
  run_until(scene, folder / "whole", never, 1, false);
  run_until(scene, folder / "stopped", 700, 1, false);
  fs::remove(folder / "start.vtkhdf");
  run_until(scene, folder / "stopped", never, 2, true);
  check_same_bytes(folder / "whole", folder / "stopped");
}

TEST_CASE("a run goes on bit for bit with boundaries in motion and stages", "[resume]") {
  const auto with = [&](const std::string& boundary) {
    return falling_scene(linear_with_springs, rough, random_places, boundary);
  };
  check_resumed("vibrating floor", with(in_motion("vibration = {amplitude = [0.001, 0, 0.002], frequency = 50}")));
  check_resumed("displaced floor", with(in_motion("displacement = [\"0.01*sin(20*t)\", \"0\", \"0\"]")));
  const std::string paddle =
      "[[boundary]]\nname = \"paddle\"\nkind = \"polygons\"\npolygons = [[[0.03, 0.075, 0.01], [0.12, 0.075, 0.01], "
      "[0.12, 0.075, 0.06], [0.03, 0.075, 0.06]]]\n";
  check_resumed("turning paddle", with(paddle + in_motion("rotation = {axis = [0, 0, 1], centre = [0.075, 0.075, 0], "
                                                          "angle = \"10*t\"}")));
  const std::string lid = "[[boundary]]\nname = \"lid\"\nkind = \"plane\"\npoint = [0, 0, 0.3]\nnormal = [0, 0, -1]\n";
  const History history =
      check_resumed("free lid", with(lid + in_motion("free = {axis = [0, 0, -1], mass = 0.5, force = \"30*t\"}")),
                    {"dynamics.duration=0.2"}, 4);
  CHECK(history.column("lid.travel").back() > 0.05);
  const std::string stages =
      "[[stage]]\nname = \"fall\"\nduration = 0.06\n[[stage]]\nname = \"press\"\nduration = 0.1\n";
  check_resumed("a lid in the second of two stages",
                with(lid + in_motion("stage = \"press\"\ndisplacement = [\"0\", \"0\", \"-0.5*t\"]") + "\n" + stages),
                {"dynamics.duration=0.16"}, 4);
}

TEST_CASE("overdamped motion goes on bit for bit, between its looks and within one", "[resume]") {
  for (const char* integrator : {"euler", "rkc", "implicit"}) {
    const std::string chosen = std::string("duration = 0.6\nintegrator = \"") + integrator + "\"";
    check_resumed(integrator, sinking_scene(chosen), {}, 4);
  }
  check_resumed("hertz", sinking_scene("duration = 0.4", "normal = \"hertz\""));
  check_resumed("given step", sinking_scene("duration = 0.4\nintegrator = \"euler\"\ntime_step = 2e-4"));
  check_resumed(
      "under a moving lid",
      sinking_scene("duration = 0.6", "normal = \"linear\"",
                    "[[boundary]]\nname = \"lid\"\nkind = \"plane\"\npoint = [0, 0, 0.2]\nnormal = [0, 0, -1]\n" +
                        in_motion("displacement = [\"0\", \"0\", \"-0.15*t\"]")));
}

TEST_CASE("a run to rest goes on bit for bit on its way, in relaxation and while it settles", "[resume]") {
  const std::vector<std::string> rest = {"dynamics.goal=rest", "dynamics.time_step=auto", "dynamics.duration=2",
                                         "output.history_interval=0.001"};
  check_resumed("rest", small_scene, rest, 4);
  std::vector<std::string> with_friction = rest;
  with_friction.insert(
      with_friction.end(),
      {"contact.tangential=cundall-strack", "material[0].tangential_stiffness=1e6",
       "material[1].tangential_stiffness=1e6", "material[0].friction=0.4", "material[1].friction=0.4"});
  check_resumed("rest with friction", small_scene, with_friction, 4);
  check_resumed("rest without inertia", sinking_scene("goal = \"rest\"\nduration = 120"),
                {"output.interval=10", "output.history_interval=0.5"}, 4);
}

TEST_CASE("checkpoints by the clock change nothing", "[resume]") {
  const TemporaryFolder folder(memory());
  const auto check = [&](const std::string& name, const std::string& text, std::vector<std::string> set) {
    run_until(parse_scene(text, name, set), folder / (name + " seldom"), never, 1, false);
    set.push_back("output.checkpoint_interval=1e-4");
    run_until(parse_scene(text, name, set), folder / (name + " often"), never, 1, false);
    check_same_bytes(folder / (name + " seldom"), folder / (name + " often"));
    CHECK(fs::exists(folder / (name + " often") / "checkpoint/checkpoint_1"));
  };
  check("growth", small_scene, {"dynamics.duration=10 ms", "output.interval=5 ms"});
  check("sinking", sinking_scene("duration = 0.2"), {});
}

TEST_CASE("of a damaged checkpoint the other is taken, of two damaged ones none", "[resume]") {
  const TemporaryFolder folder(memory());
  const Scene scene = parse_scene(small_scene, "s.toml", {"output.checkpoint_interval=1e-9", "dynamics.duration=4 ms"});
  run_until(scene, folder / "whole", never, 1, false);
  run_until(scene, folder / "stopped", 100, 1, false);
  const auto found = Checkpoints(folder / "stopped").find();
  REQUIRE(found.size() == 2);
  const auto newest = *Checkpoints::newest(found);
  // One bit, wherever it is, is noticed.
  const std::string good = read_text_file(newest.file);
  std::mt19937 random(5);
  for (int k = 0; k < 200; ++k) {
    std::string bad = good;
    bad[random() % bad.size()] ^= static_cast<char>(1u << random() % 8);
    std::ofstream(newest.file, std::ios::binary) << bad;
    CHECK_THROWS_AS(CheckpointReader(newest.file), InputError);
    std::ofstream(newest.file, std::ios::binary) << good.substr(0, random() % good.size());
    CHECK_THROWS_AS(CheckpointReader(newest.file), InputError);
  }
  CHECK(Checkpoints::newest(Checkpoints(folder / "stopped").find())->file != newest.file);
  CHECK(state_of_run(folder / "stopped").checkpoints.size() == 2);
  // What stands beside it is made again.
  fs::remove(folder / "stopped/run.json");
  fs::remove(folder / "stopped/scene.toml");
  run_until(scene, folder / "stopped", never, 1, true);
  check_same_bytes(folder / "whole", folder / "stopped");

  run_until(scene, folder / "lost", 100, 1, false);
  for (const FoundCheckpoint& one : Checkpoints(folder / "lost").find()) fs::resize_file(one.file, 1000);
  const std::string history = read_text_file(folder / "lost/history.csv");
  RunControl control;
  control.resume = true;
  CHECK_THROWS_WITH(run_scene(scene, folder / "lost", control), Contains("cut short") && Contains("--overwrite"));
  CHECK(read_text_file(folder / "lost/history.csv") == history);
}

TEST_CASE("going on is refused with another scene, in a folder at work, and of a finished run", "[resume]") {
  const TemporaryFolder folder(memory());
  const auto scene = [](const std::vector<std::string>& set = {}) { return parse_scene(small_scene, "s.toml", set); };
  run_until(scene(), folder / "run", 300, 1, false);
  RunControl control;
  control.resume = true;
  std::string noted;
  control.note = [&](const std::string& text) { noted = text; };
  CHECK_THROWS_WITH(run_scene(scene({"material[1].density=7000", "seed=4"}), folder / "run", control),
                    Contains("material[1].density") && Contains("seed") && !Contains("radius"));
  CHECK_THROWS_WITH(run_scene(scene({"dynamics.duration=2"}), folder / "run", control), Contains("dynamics.duration"));
  {
    const FolderLock at_work(folder / "run");
    CHECK_THROWS_WITH(run_scene(scene(), folder / "run", control), Contains("at work"));
    CHECK(state_of_run(folder / "run").at_work);
  }
  CHECK(scene_hash(scene_of_earlier_run(folder / "run", {})) == scene_hash(scene()));
  // The interval between checkpoints is no part of the scene.
  run_scene(scene({"output.checkpoint_interval=5"}), folder / "run", control);
  CHECK_THAT(noted, Contains("goes on from checkpoint_"));
  const std::string record = read_text_file(folder / "run/run.json");
  run_scene(scene(), folder / "run", control);
  CHECK_THAT(noted, Contains("is finished"));
  CHECK(read_text_file(folder / "run/run.json") == record);
  // Where there is nothing to go on from, it begins.
  CHECK(run_scene(scene(), folder / "new", control).steps == 4000);
  CHECK_THAT(noted, Contains("no checkpoint"));
}

TEST_CASE("a history that is shorter than the checkpoint counts is not gone on with", "[resume]") {
  const TemporaryFolder folder(memory());
  const Scene scene = parse_scene(small_scene, "s.toml");
  run_until(scene, folder / "run", 700, 1, false);
  fs::resize_file(folder / "run/history.csv", 100);
  RunControl control;
  control.resume = true;
  CHECK_THROWS_WITH(run_scene(scene, folder / "run", control), Contains("history.csv") && Contains("--overwrite"));
}
