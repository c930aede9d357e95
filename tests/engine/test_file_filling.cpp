// Starts from a CSV table, a LAMMPS data file and a snapshot: what is read, and what is refused before anything is
// written.
#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/run_folder.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/filling/filling.hpp"
#include "engine/filling/population.hpp"
#include "engine/run.hpp"
#include "engine/time_step.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::engine;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using packstone::testing::file_scene;
using packstone::testing::small_scene;
using packstone::testing::TemporaryFolder;

namespace {

const std::string lammps_file = std::string(PACKSTONE_SOURCE_DIR) + "/tests/data/lammps_sphere.data";

StartingState started_from(const Scene& scene) { return fill(scene, scene.box(), Boundaries(scene, scene.box())); }

StartingState started_from(const std::string& content, const std::string& name = "start.csv",
                           const std::vector<std::string>& set = {}) {
  const TemporaryFolder folder;
  write_text_file(folder / name, content);
  return started_from(parse_scene(file_scene((folder / name).string()), "s.toml", set));
}

/// The message of a refused start, with the file's name alone; checks that no run folder comes into being.
std::string refusal(const std::string& content, const std::string& name = "start.csv",
                    const std::vector<std::string>& set = {}) {
  const TemporaryFolder folder;
  write_text_file(folder / name, content);
  const Scene scene = parse_scene(file_scene((folder / name).string()), "s.toml", set);
  try {
    run_scene(scene, folder / "run", {});
  } catch (const InputError& error) {
    CHECK_FALSE(std::filesystem::exists(folder / "run"));
    const std::string what = error.what();
    const std::string before = folder.path().string() + "/";
    return what.starts_with(before) ? what.substr(before.size()) : what;
  }
  return "no refusal";
}

/// The LAMMPS fixture with the first occurrence of one text replaced.
std::string lammps_with(const std::string& from, const std::string& to) {
  std::string text = read_text_file(lammps_file);
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a table's columns come in any order, with what is left out at its default") {
  const StartingState s = started_from(
      "# by hand\r\n\r\n radius , z,y, x ,group,vx,wz\r\n"
      "0.02,0.1,0.05,0.06,1,1.5,-2 # moves\r\n"
      "+1e-2, 3.0e-1 ,.05,0.16,0.0,0,0\r\n");
  REQUIRE(s.size() == 2);
  CHECK(s.position[0] == Vec3(0.06, 0.05, 0.1));
  CHECK(s.velocity[0] == Vec3(1.5, 0, 0));
  CHECK(s.angular_velocity[0] == Vec3(0, 0, -2));
  CHECK(s.radius == std::vector<double>{0.02, 0.01});
  CHECK(s.type == std::vector<std::int32_t>{1, 0});
  CHECK(s.position[1] == Vec3(0.16, 0.05, 0.3));
  CHECK(started_from("x,y,z,radius\n0.1,0.1,0.1,0.02").type == std::vector<std::int32_t>{0});
}

TEST_CASE("a place outside a periodic side is the one inside, outside an open face stays") {
  const StartingState s = started_from("x,y,z,radius\n0.25,-0.05,0.7,0.02\n");
  CHECK(s.position[0].x() == Approx(0.05));
  CHECK(s.position[0].y() == Approx(0.15));
  CHECK(s.position[0].z() == 0.7);
}

TEST_CASE("a table that is not right is refused with line and column") {
  const auto row = [](const std::string& text) { return refusal("x,y,z,radius,group\n0.1,0.1,0.1,0.02,0\n" + text); };
  CHECK_THAT(refusal(""), StartsWith("start.csv: is empty; expected a header line"));
  CHECK_THAT(refusal("x,y,z,radius\n# none\n"), StartsWith("start.csv: holds no particles"));
  CHECK_THAT(refusal("x,y,z,radus\n"),
             StartsWith("start.csv:1: \"radus\" is an unknown column; did you mean \"radius\"?"));
  CHECK_THAT(refusal("\n0.1,0.1,0.1,0.02\n"), StartsWith("start.csv:2: \"0.1\" is no column's name"));
  CHECK_THAT(refusal("x,y,radius\n"), StartsWith("start.csv:1: z: the header lacks this column"));
  CHECK_THAT(refusal("x,y,z,x,radius\n"), StartsWith("start.csv:1: x: the header names this column twice"));
  CHECK_THAT(row("0.1,0.1,0.2,0.02"), StartsWith("start.csv:3: the row has 4 fields, the header 5"));
  CHECK_THAT(row("0.1,0.1,0.2,0.02,0,"), StartsWith("start.csv:3: the row has 6 fields, the header 5"));
  CHECK_THAT(row("0.1,,0.2,0.02,0"), StartsWith("start.csv:3: y: \"\" is not a number"));
  CHECK_THAT(row("0.1,0.1 m,0.2,0.02,0"), StartsWith("start.csv:3: y: \"0.1 m\" is not a number"));
  CHECK_THAT(row("0.1,0.1,nan,0.02,0"), StartsWith("start.csv:3: z: \"nan\" is not finite"));
  CHECK_THAT(row("0.1,0.1,0.2,inf,0"), StartsWith("start.csv:3: radius: \"inf\" is not finite"));
  CHECK_THAT(row("0.1,0.1,0.2,0,0"), StartsWith("start.csv:3: radius: 0 m is out of range; it must be greater than 0"));
  CHECK_THAT(row("0.1,0.1,0.2,-0.02,0"), StartsWith("start.csv:3: radius: -0.02 m"));
  CHECK_THAT(row("0.1,0.1,0.2,0.02,0.5"), StartsWith("start.csv:3: group: \"0.5\" is not a whole number"));
  CHECK_THAT(row("0.1,0.1,0.2,0.02,2"),
             StartsWith("start.csv:3: group: 2 is not a [[particles]] entry") && EndsWith("from 0 to 1"));
  CHECK_THAT(row("0.1,0.1,0.2,0.02,-1"), StartsWith("start.csv:3: group: -1"));
}

TEST_CASE("a particle outside the domain or behind a wall is refused") {
  const auto row = [](const std::string& text, const std::vector<std::string>& set = {}) {
    return refusal("x,y,z,radius\n" + text, "start.csv", set);
  };
  const std::vector<std::string> closed = {"domain.open=[]", "domain.periodic=[\"x\"]"};
  CHECK_THAT(row("0.1,0.1,0.41,0.02", closed), StartsWith("start.csv:2: z: 0.41 m lies outside the domain, whose upper "
                                                          "side is at 0.4 m") &&
                                                   Contains("domain.open"));
  CHECK_THAT(row("0.1,-0.1,0.1,0.02", closed), StartsWith("start.csv:2: y: -0.1 m") && Contains("lower"));
  CHECK_THAT(row("0.1,0.1,0.81,0.02"), StartsWith("start.csv:2: z: 0.81 m") && Contains("domain's length"));
  CHECK_THAT(row("100,0.1,0.1,0.02"), StartsWith("start.csv:2: x: 100 m") && Contains("lengths are in m"));
  CHECK_THAT(row("0.1,0.1,0.01,0.02", {"boundary[0].point=[0, 0, 0.05]"}),
             StartsWith("start.csv:2: x, y, z: the centre lies behind the boundary floor"));
  CHECK_THAT(row("0.1,0.1,0.1,0.06"), Contains("the periodic side along x is 0.2 m"));
}

TEST_CASE("a file that is not there is named at the scene's key") {
  CHECK_THROWS_WITH(started_from(parse_scene(file_scene("/no/such/start.csv"), "s.toml")),
                    StartsWith("s.toml:31:1: filling.path: /no/such/start.csv: no such file"));
  CHECK_THROWS_WITH(started_from(parse_scene(file_scene("/tmp"), "s.toml")),
                    Contains("filling.path: /tmp: not a file"));
}

TEST_CASE("a data file that LAMMPS wrote is read by ascending id") {
  const StartingState s = started_from(parse_scene(file_scene(lammps_file), "s.toml"));
  REQUIRE(s.size() == 4);
  CHECK(s.position[1] == Vec3(0.15, 0.06, 0.3));
  CHECK(s.position[2] == Vec3(0.05, 0.16, 0.2));
  CHECK(s.position[3] == Vec3(0.151, 0.161, 0.11));
  CHECK(s.radius == std::vector<double>{0.02, 0.015, 0.02, 0.015});
  CHECK(s.type == std::vector<std::int32_t>{0, 1, 0, 1});
  CHECK(s.velocity[3] == Vec3(0.05620588040382156, -0.12871053024336984, -0.07879631025311801));
  CHECK(s.angular_velocity[0] == Vec3(0, 0, 0));
  CHECK(s.angular_velocity[3] == Vec3(1, 2, 3));
  CHECK(s.source_hash == content_hash(read_text_file(lammps_file)));
  // Without velocities and image flags the atoms are at rest.
  const StartingState resting =
      started_from("title\n\n1 atoms\n1 atom types\n\nAtoms\n\n7 1 0.04 1200 0.1 0.1 0.1\n", "rest.data");
  CHECK(resting.velocity[0] == Vec3(0, 0, 0));
  CHECK(resting.position[0] == Vec3(0.1, 0.1, 0.1));
}

TEST_CASE("a data file that does not fit is refused with its line") {
  const auto after = [](const std::string& from, const std::string& to) {
    return refusal(lammps_with(from, to), "start.data");
  };
  CHECK_THAT(after("timestep = 0", "timestep = 0, units = lj"), StartsWith("start.data:1: the file is in units lj"));
  CHECK_THAT(after("# sphere", "# atomic"), StartsWith("start.data:10: Atoms: atom_style atomic has no radius"));
  CHECK_THAT(after("1 1 0.04 1200", "1 1 1200"),
             StartsWith("start.data:12: Atoms: the row has 9 fields") && Contains("id type diameter density x y z"));
  CHECK_THAT(after("4 2 0.03", "4 3 0.03"), StartsWith("start.data:13: type: 3 has no [[particles]] entry"));
  CHECK_THAT(after("4 2 0.03", "4 0 0.03"), StartsWith("start.data:13: type: 0 has no"));
  CHECK_THAT(after("4 2 0.03", "4 2 0"), StartsWith("start.data:13: diameter: 0 m is out of range"));
  CHECK_THAT(after("7800", "7801"), StartsWith("start.data:13: density: 7801 kg/m3 differs from the 7800 kg/m3 of the "
                                               "scene's material \"heavy\""));
  CHECK_THAT(after("0.161", "nan"), StartsWith("start.data:13: y: \"nan\" is not a finite number"));
  CHECK_THAT(after("4 2 0.03", "x 2 0.03"), StartsWith("start.data:13: id: \"x\" is not a whole number"));
  CHECK_THAT(after("4 2 0.03", "1 2 0.03"), StartsWith("start.data:13: id: 1 occurs twice"));
  CHECK_THAT(after("4 atoms", "5 atoms"), StartsWith("start.data: the section Atoms holds 4 atoms, the header says 5"));
  CHECK_THAT(after("Velocities\n\n1", "Velocities\n\n9"), StartsWith("start.data:19: id: 9 has a velocity"));
  CHECK_THAT(after("Velocities\n\n1", "Velocities\n\n1 1"), StartsWith("start.data:19: Velocities: the row has 8"));
  CHECK_THAT(after("1 0.058", "1 _"), StartsWith("start.data:19: vx: \"_"));
  CHECK_THAT(after("0.05 0.16 0.2", "0.05 0.16 2"), StartsWith("start.data:14: z: 2 m lies outside the domain"));
}

TEST_CASE("a run goes on from a snapshot where another one was") {
  const TemporaryFolder folder;
  run_scene(parse_scene(small_scene, "s.toml"), folder / "first", {});
  const RunReader first(folder / "first");
  const auto file = first.snapshot_files().back();
  const std::vector<std::string> set = {"dynamics.duration=1 ms", "output.interval=1 ms"};
  const RunRecord record = run_scene(parse_scene(file_scene(file.string()), "s.toml", set), folder / "second", {});
  CHECK(record.particles == 120);
  CHECK(record.filling_hash == content_hash(read_text_file(file)));
  CHECK(first.record().filling_hash.empty());
  const RunReader second(folder / "second");
  CHECK(second.record().filling_hash == record.filling_hash);

  const Snapshot end = first.snapshot(first.snapshot_count() - 1), start = second.snapshot(0);
  REQUIRE(start.size() == end.size());
  CHECK(start.position == end.position);
  CHECK(start.radius == end.radius);
  CHECK(start.type == end.type);
  CHECK(start.id == end.id);
  CHECK(start.contacts->size() == end.contacts->size());
  // The velocities read count half a step earlier than the positions.
  const double half_step = 0.5 * 20e-6;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto vector = [i](const Snapshot& s, const char* name) { return Vec3(&s.fields.at(name).values[3 * i]); };
    const Vec3 gained = half_step / start.mass(i) * vector(start, "force");
    CHECK((vector(start, "velocity") - vector(end, "velocity") - gained).norm() < 1e-12);
  }
  // What the particles came with is not energy from nowhere.
  CHECK(second.history().column("energy_error").front() == 0);
  CHECK(second.history().column("kinetic_translational").front() > 0);
}

TEST_CASE("a snapshot's ids decide the order, two of the same are refused") {
  const TemporaryFolder folder;
  run_scene(parse_scene(small_scene, "s.toml"), folder / "run", {});
  Snapshot s = read_snapshot(RunReader(folder / "run").snapshot_files().back(), {.region = {}, .contacts = false});
  const auto start = [&] {
    write_snapshot(folder / "renamed.vtkhdf", s);
    return started_from(parse_scene(file_scene((folder / "renamed.vtkhdf").string()), "s.toml"));
  };
  const StartingState before = start();
  CHECK(before.type.front() == 0);
  CHECK(before.type.back() == 1);
  for (std::int64_t& id : s.id) id = 1000 - 3 * id;
  const StartingState turned = start();
  CHECK(std::equal(before.position.begin(), before.position.end(), turned.position.rbegin(), turned.position.rend()));
  s.id[7] = s.id[8] = 40;
  CHECK_THROWS_WITH(start(), Contains("renamed.vtkhdf: PointData/id: 40 occurs twice"));
}

TEST_CASE("a snapshot from the beginning of growth and a damaged one are refused") {
  const TemporaryFolder folder;
  run_scene(parse_scene(small_scene, "s.toml", {"dynamics.duration=1 ms"}), folder / "run", {});
  const auto file = RunReader(folder / "run").snapshot_files().front();
  const auto start = [](const std::filesystem::path& path) {
    return started_from(parse_scene(file_scene(path.string()), "s.toml"));
  };
  CHECK_THROWS_WITH(start(file), StartsWith(file.string() + ": particle 0: radius: 0 m is out of range"));
  write_text_file(folder / "cut.vtkhdf", read_text_file(file).substr(0, 500));
  CHECK_THROWS_WITH(start(folder / "cut.vtkhdf"), Contains("cut.vtkhdf: not a readable HDF5 file"));
  write_text_file(folder / "other.vtkhdf", "x,y,z,radius\n");
  CHECK_THROWS_AS(start(folder / "other.vtkhdf"), InputError);
}

TEST_CASE("the step limit and the periodic sides see the sizes that the file really has") {
  const TemporaryFolder folder;
  const std::string path = (folder / "start.csv").string();
  write_text_file(path, "x,y,z,radius,group\n0.1,0.1,0.1,0.02,0\n0.1,0.1,0.2,0.002,0\n0.1,0.1,0.3,0.03,1\n");
  const Scene scene = parse_scene(file_scene(path), "s.toml");
  const Population population = population_of(scene, started_from(scene));
  REQUIRE(population.size() == 2);
  CHECK(population[0].count == 2);
  CHECK(population[0].smallest_radius == 0.002);
  CHECK(population[0].largest_radius == 0.02);
  CHECK(population[1].smallest_radius == 0.03);
  CHECK(largest_radius(population) == 0.03);
  const double mass = 1200 * 4.0 / 3.0 * M_PI * std::pow(0.002, 3);
  CHECK(step_limit(scene, population).limit == Approx(2 * std::sqrt(0.5 * mass / (1e6 * 1.7))));
  CHECK(step_limit(scene, population).pair == "light - light");
  // A group that the file leaves empty has no contacts.
  write_text_file(path, "x,y,z,radius,group\n0.1,0.1,0.1,0.02,1\n");
  CHECK(step_limit(scene, population_of(scene, started_from(scene))).pair == "heavy - heavy");
}

TEST_CASE("particles that overlap too much in the file stop the run with the file's name") {
  const TemporaryFolder folder;
  const std::string path = (folder / "start.csv").string();
  write_text_file(path, "x,y,z,radius\n0.1,0.1,0.1,0.02\n0.13,0.1,0.1,0.02\n");
  CHECK_THROWS_WITH(run_scene(parse_scene(file_scene(path), "s.toml"), folder / "run", {}),
                    Contains("t = 0 s, step 0: particle 0 (light) and particle 1 (light) overlap by 50.0 %") &&
                        Contains("they overlap so in " + path) && !Contains("filling.duration"));
}

TEST_CASE("a spin that friction can feel is started with") {
  const TemporaryFolder folder;
  const std::string path = (folder / "start.csv").string();
  write_text_file(path, "x,y,z,radius,wx,wy,wz\n0.1,0.1,0.3,0.02,1,2,3\n");
  run_scene(parse_scene(file_scene(path), "s.toml",
                        {"contact.tangential=cundall-strack", "material[0].tangential_stiffness=1e6",
                         "material[1].tangential_stiffness=1e6", "material[0].friction=0.4", "dynamics.duration=1 ms",
                         "output.fields=[\"angular_velocity\"]"}),
            folder / "run", {});
  const RunReader run(folder / "run");
  CHECK(run.snapshot(0).fields.at("angular_velocity").values == std::vector<double>{1, 2, 3});
  CHECK(run.snapshot(1).fields.at("angular_velocity").values == std::vector<double>{1, 2, 3});
}
