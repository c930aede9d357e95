// packstone convert, and the other verbs on files of other programs.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using testing::packstone_command;
using testing::quoted;
using testing::TemporaryFolder;

namespace {

const std::filesystem::path peers = PACKSTONE_SOURCE_DIR "/tests/data/peers";

}  // namespace

TEST_CASE("a dump goes into a run folder and every other format") {
  const TemporaryFolder folder;
  const std::string dump = quoted(peers / "liggghts.dump");
  auto result = packstone_command("convert " + dump + " " + quoted(folder / "run") + " --time-step 2e-5 --quiet");
  INFO(result.output);
  REQUIRE(result.exit_code == 0);
  CHECK(result.output.empty());
  const RunReader run(folder / "run");
  REQUIRE(run.snapshot_count() == 3);
  CHECK(run.times()[2] == Approx(4e-4));
  CHECK(run.record().particles == 45);
  CHECK(run.snapshot(2).contacts->size() > 0);
  CHECK(run.snapshot(2).contacts->sliding.empty());
  for (const char* name : {"a.dump", "a.data", "a.csv", "a.xyz", "a.vtu", "a.vtp", "a.vtkhdf"}) {
    CAPTURE(name);
    result = packstone_command("convert " + dump + " " + quoted(folder / name) + " --quiet");
    CHECK(result.exit_code == 0);
  }
  CHECK(RunReader(folder / "a.dump").snapshot_count() == 3);
  const Snapshot last = run.snapshot(2), table = RunReader(folder / "a.csv").snapshot(0);
  const auto rows = last.rows_by_id();
  for (std::size_t i = 0; i < table.size(); ++i) CHECK(table.position[i] == last.position[rows.at(table.id[i])]);
}

TEST_CASE("a scene gives the domain, groups, boundaries and gravity that a file lacks") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  std::ofstream(folder / "a.csv") << "x,y,z,radius,type\n0.1,0.1,0.02,0.02,0\n0.25,0.1,0.1,0.02,1\n";
  auto result = packstone_command("convert " + quoted(folder / "a.csv") + " " + quoted(folder / "a.vtkhdf") +
                                  " --like " + quoted(folder / "scene.toml"));
  INFO(result.output);
  REQUIRE(result.exit_code == 0);
  CHECK(result.output.empty());  // nothing had to be assumed
  const Snapshot s = read_snapshot(folder / "a.vtkhdf");
  CHECK(s.domain.max == Vec3(0.2, 0.2, 0.4));
  CHECK(s.domain.periodic == std::array<bool, 3>{true, true, false});
  CHECK(s.gravity == Vec3(0, 0, -9.8));
  REQUIRE(s.boundaries.size() == 1);
  CHECK(s.boundaries[0].name == "floor");
  CHECK(s.groups[1].name == "heavy");
  CHECK(s.groups[1].density == 7800);
  const auto rows = s.rows_by_id();
  CHECK(s.position[rows.at(1)].x() == Approx(0.05));  // its image inside
  CHECK(s.material[rows.at(1)] == 1);

  std::ofstream(folder / "b.csv") << "x,y,z,radius,type\n0.1,0.1,0.02,0.02,2\n";
  result = packstone_command("convert " + quoted(folder / "b.csv") + " " + quoted(folder / "b.vtkhdf") + " --like " +
                             quoted(folder / "scene.toml"));
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.output, Contains("b.csv: particle 0 is of type 2") && Contains("has 2 [[particles]]"));
  std::ofstream(folder / "b.csv") << "x,y,z,radius\n100,0.1,0.02,0.02\n";
  result = packstone_command("convert " + quoted(folder / "b.csv") + " " + quoted(folder / "b.vtkhdf") + " --like " +
                             quoted(folder / "scene.toml"));
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.output, Contains("far outside the scene's domain"));
  CHECK_FALSE(std::filesystem::exists(folder / "b.vtkhdf"));
}

TEST_CASE("walls of a dump are the scene's boundaries, in their order") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ";
  const std::string box = "\nITEM: BOX BOUNDS pp pp ff\n0 0.2\n0 0.2\n0 0.4\nITEM: ";
  std::ofstream(folder / "a.dump") << head << "ATOMS\n1" << box
                                   << "ATOMS id type x y z radius\n1 1 0.1 0.1 0.019 0.02\n";
  std::ofstream(folder / "pairs") << head << "ENTRIES\n0" << box << "ENTRIES id1 id2 fx fy fz\n";
  const auto convert = [&](const std::string& wall) {
    std::ofstream(folder / "walls") << head << "ENTRIES\n1" << box << "ENTRIES a b c d e f g h\n0.1 0.1 0 1 " << wall
                                    << " 0 0 3\n";
    return packstone_command("convert " + quoted(folder / "a.dump") + " " + quoted(folder / "a.vtkhdf") + " --like " +
                             quoted(folder / "scene.toml") + " --contacts " + quoted(folder / "pairs") +
                             " --wall-contacts " + quoted(folder / "walls") +
                             " --wall-columns px,py,pz,id,wall,fx,fy,fz --overwrite");
  };
  auto result = convert("0");
  INFO(result.output);
  REQUIRE(result.exit_code == 0);
  CHECK(result.output.empty());
  const Snapshot s = read_snapshot(folder / "a.vtkhdf");
  REQUIRE(s.contacts.value().size() == 1);
  CHECK(s.contacts->second[0] == -1);
  CHECK(s.contacts->force[0] == Vec3(0, 0, 3));
  REQUIRE(s.boundaries.size() == 1);
  CHECK(s.boundaries[0].name == "floor");
  result = convert("1");
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.output, Contains("with 2 walls, the scene has 1 [[boundaries]]"));
}

TEST_CASE("info and analyze take files of other programs, and say what had to be assumed") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "#format x_y_z_r\n0 0 0 1\n1.9 0 0 1\n";
  auto result = packstone_command("info " + quoted(folder / "a.txt") + " --json");
  REQUIRE(result.exit_code == 0);
  const auto info = nlohmann::json::parse(result.output);
  CHECK(info["last_snapshot"]["particles"] == 2);
  CHECK(info["last_snapshot"]["notes"].size() == 2);
  result = packstone_command("analyze " + quoted(folder / "a.txt") + " --only structure");
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.output, Contains("note: the file has no box") && Contains("rebuilt from geometry"));
  result = packstone_command("analyze " + quoted(peers / "lammps.dump") + " --only forces --json -");
  REQUIRE(result.exit_code == 0);
  CHECK(nlohmann::json::parse(result.output)["forces"]["normal_force_mean"]["value"].is_number());
}

TEST_CASE("a wrong call of convert gives one line and exit code 2, and spoils nothing") {
  const TemporaryFolder folder;
  const std::string dump = quoted(peers / "liggghts.dump");
  std::ofstream(folder / "kept.csv") << "thesis";
  for (const std::string& call :
       {std::string("convert"), "convert " + dump, "convert " + dump + " " + quoted(folder / "a.png"),
        "convert " + dump + " " + quoted(folder / "kept.csv"),
        "convert " + dump + " --at all " + quoted(folder / "a.csv"),
        "convert " + dump + " --at 7 " + quoted(folder / "a.csv"),
        "convert " + dump + " --time-step -1 " + quoted(folder / "a.csv"),
        "convert " + dump + " --like " + quoted(folder / "no.toml") + " " + quoted(folder / "a.csv"),
        "convert " + dump + " --contacts " + quoted(folder / "no.local") + " " + quoted(folder / "a.csv"),
        "convert " + dump + " --wall-contacts " + quoted(folder / "no.wall") + " " + quoted(folder / "a.csv"),
        "convert " + quoted(folder / "absent*") + " " + quoted(folder / "a.csv")}) {
    const auto result = packstone_command(call);
    INFO(call << "\n" << result.output);
    CHECK(result.exit_code == 2);
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    CHECK_THAT(result.output, StartsWith("packstone: error: "));
  }
  CHECK(read_text_file(folder / "kept.csv") == "thesis");
  CHECK_FALSE(std::filesystem::exists(folder / "a.csv"));
  CHECK(packstone_command("convert " + dump + " " + quoted(folder / "kept.csv") + " --overwrite --quiet").exit_code ==
        0);
  CHECK(RunReader(folder / "kept.csv").snapshot(0).size() == 45);
}
