// Exit codes and messages of the command: one clear line for every wrong call, and nothing written.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "core/files.hpp"
#include "core/scene.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using testing::file_scene;
using testing::packstone_command;
using testing::quoted;
using testing::small_scene;
using testing::small_scene_with;
using testing::TemporaryFolder;

namespace {

bool one_line(const std::string& text) { return std::count(text.begin(), text.end(), '\n') == 1; }

}  // namespace

TEST_CASE("a wrong scene gives one line, exit code 2 and no folder") {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& scene, const std::string& message) {
    std::ofstream(folder / "scene.toml") << scene;
    const auto result = packstone_command("run " + quoted(folder / "scene.toml") + " -o " + quoted(folder / "run"));
    INFO(result.output);
    CHECK(result.exit_code == 2);
    CHECK(one_line(result.output));
    CHECK_THAT(result.output, StartsWith("packstone: error: ") && Contains(message));
    CHECK_FALSE(std::filesystem::exists(folder / "run"));
  };
  const std::string place = (folder / "scene.toml").string();
  check(small_scene_with("duration = \"80 ms\"", "durtion = \"80 ms\""), place + ":5:1: dynamics.durtion: unknown key");
  check(small_scene_with("radius = \"20 mm\"", "radius = -0.02"), place + ":29:1: particles[0].radius");
  check(small_scene_with("material = \"light\"", "material = \"lead\""), place + ":27:1: particles[0].material");
  check(small_scene_with("time_step = \"20 us\"", "time_step = \"2 ms\""),
        place + ":4:1: dynamics.time_step: 2e+03 us");
  check(small_scene_with("count = 60", "count = 600"), "do not fit");
  check(small_scene_with("seed = 3", "seed = "), "not valid TOML");
  std::ofstream(folder / "start.csv") << "x,y,z,radius\n0.1,0.1,0.1,-1\n";
  check(file_scene("start.csv"), (folder / "start.csv").string() + ":2: radius: -1 m is out of range");
}

TEST_CASE("a missing scene, an unwritable output and a wrong call give one line and exit code 2") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << small_scene;
  const std::string scene = quoted(folder / "scene.toml");
  for (const std::string& call :
       {"run " + quoted(folder / "absent.toml"), "run " + scene + " -o /proc/packstone", std::string("run"),
        "run " + scene + " --threads 0", std::string("fly"), std::string(""), "run " + scene + " --set nonsense",
        std::string("analyze /no/such/run"), std::string("analyze"), std::string("info /no/such/run"),
        "info " + quoted(folder.path()), "analyze " + scene}) {
    const auto result = packstone_command(call);
    INFO(call << "\n" << result.output);
    CHECK(result.exit_code == 2);
    CHECK(one_line(result.output));
    CHECK_THAT(result.output, StartsWith("packstone: error: "));
  }
}

TEST_CASE("a run goes through info and analyze") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << small_scene;
  const std::string run = quoted(folder / "a run");
  auto result = packstone_command("run " + quoted(folder / "scene.toml") + " -o " + run + " --quiet");
  INFO(result.output);
  REQUIRE(result.exit_code == 0);
  CHECK(result.output.empty());

  result = packstone_command("info " + run + " --json");
  REQUIRE(result.exit_code == 0);
  const auto info = nlohmann::json::parse(result.output);
  CHECK(info["status"] == "finished");
  CHECK(info["snapshots"] == 5);
  CHECK(info["last_snapshot"]["groups"][1]["count"] == 60);

  result = packstone_command("analyze " + run + " --json - --csv " + quoted(folder / "tables"));
  REQUIRE(result.exit_code == 0);
  const auto measures = nlohmann::json::parse(result.output);
  CHECK(measures["packing"]["bulk_fraction"]["value"].is_number());
  CHECK(measures["structure"]["coordination_mean"]["value"].is_number());
  CHECK(measures["segregation"]["lacey"]["value"].is_number());
  CHECK(std::filesystem::exists(folder / "tables/measures.csv"));

  result =
      packstone_command("analyze " + run + " --at all --only packing --quiet --json " + quoted(folder / "all.json"));
  CHECK(result.exit_code == 0);
  CHECK(nlohmann::json::parse(read_text_file(folder / "all.json")).size() == 5);

  for (const char* wrong : {" --only pcking", " --at 17", " --at soon", " --csv /proc/x"}) {
    result = packstone_command("analyze " + run + wrong + " --quiet");
    INFO(wrong << ": " << result.output);
    CHECK(result.exit_code != 0);
    CHECK(one_line(result.output));
  }
  result = packstone_command("run " + quoted(folder / "scene.toml") + " -o " + run);
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.output, Contains("--overwrite"));
}

TEST_CASE("analyze writes what is known at places: map, coarse fields, surface, particles") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << small_scene;
  const std::string run = quoted(folder / "run");
  REQUIRE(packstone_command("run " + quoted(folder / "scene.toml") + " -o " + run + " --quiet").exit_code == 0);
  const std::vector<std::pair<std::string, std::string>> files = {
      {"--map", "map.vti"}, {"--coarse", "coarse.vti"}, {"--surface", "surface.vtp"}, {"--particles", "particles.csv"}};
  std::string all = "analyze " + run + " --only packing,structure";
  for (const auto& [option, name] : files) all += " " + option + " " + quoted(folder / name);
  auto result = packstone_command(all);
  INFO(result.output);
  REQUIRE(result.exit_code == 0);
  for (const auto& [option, name] : files) CHECK(std::filesystem::file_size(folder / name) > 1000);
  const std::string particles = read_text_file(folder / "particles.csv");
  CHECK_THAT(particles.substr(0, particles.find('\n')), Contains("radius [m]") && Contains("coordination"));
  CHECK(std::count(particles.begin(), particles.end(), '\n') == 1 + 120);

  const auto refused = [&](const std::string& call, const std::string& message) {
    result = packstone_command("analyze " + run + call);
    INFO(call << ": " << result.output);
    CHECK(result.exit_code == 2);
    CHECK(one_line(result.output));
    CHECK_THAT(result.output, Contains(message));
  };
  for (const auto& [option, name] : files) {
    const std::string file = quoted(folder / ("new_" + name));
    refused(" --only packing --at all " + option + " " + file, option + " takes one instant");
    refused(" " + run + " --only packing " + option + " " + file, option + " takes one run");
    refused(" --only packing " + option + " " + quoted(folder / "new.txt"), "new.txt");
  }
  refused(" --only packing --particles " + quoted(folder / "new.csv"), "has values of particles");
  refused(" --only surface --surface-step 1e-9", "--surface-step");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    CHECK_THAT(entry.path().filename().string(), !StartsWith("new"));
  }
}

TEST_CASE("a run that fails gives exit code 1, one that is interrupted 130, both with what they have") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << small_scene;
  const std::string scene = quoted(folder / "scene.toml");
  auto result = packstone_command("run " + scene + " --quiet -o " + quoted(folder / "lost") +
                                  " --set 'gravity.acceleration=[0, 0, 5000]' --set dynamics.duration=1");
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.output, StartsWith("packstone: error: t = ") && Contains("z+"));

  result = packstone_command("run " + scene + " --quiet --set dynamics.duration=1000 -o " + quoted(folder / "long"),
                             "timeout --foreground -s INT 2");
  CHECK_THAT(result.output, Contains("packstone: interrupted: stopped at t = ") && Contains("--resume -o "));
  CHECK_THAT(packstone_command("info " + quoted(folder / "long")).output, Contains("interrupted"));
}

TEST_CASE("help and the reference of the scene's keys come from one declaration") {
  CHECK_THAT(packstone_command("run --help").output, Contains("time_step") && Contains("hysteretic"));
  CHECK(packstone_command("info --scene-reference markdown").output == scene_reference_markdown());
  CHECK(packstone_command("--version").exit_code == 0);
}

TEST_CASE("check --minimal writes the simpler scene with what was changed") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const std::string scene = (folder / "scene.toml").string(), minimal = (folder / "minimal.toml").string();
  const auto result =
      packstone_command("check " + scene + " --set contact.tangential=coulomb --set dynamics.time_step=1e-6 " +
                        "--minimal " + minimal + " --keep contact.tangential");
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.output, Contains("what it could do without") && Contains("dynamics.time_step"));
  const std::string text = read_text_file(minimal);
  CHECK_THAT(text, StartsWith("# Simplified from") && Contains("# dynamics.time_step: \"auto\"") &&
                       Contains("# contact.tangential kept"));
  CHECK(packstone_command("check " + minimal).exit_code == 0);
  const auto refused = packstone_command("check " + scene + " --minimal " + minimal + " --keep title");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.output, Contains("--keep title"));
  const auto itself = packstone_command("check " + scene + " --minimal " + scene);
  CHECK(itself.exit_code == 2);
  CHECK(read_text_file(scene) == testing::small_scene);
}

TEST_CASE("check and run tell the way to rest") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const std::string scene = (folder / "scene.toml").string() +
                            " --set dynamics.goal=rest --set dynamics.time_step=auto --set dynamics.duration=2";
  const auto told = packstone_command("check " + scene + " --json");
  REQUIRE(told.exit_code == 0);
  const auto check = nlohmann::json::parse(told.output);
  CHECK(check["way"]["stiffness_factor"]["value"] < 1);
  CHECK(check["way"]["resting_overlap"]["value"] <= 0.002 * 1.0001);
  CHECK_THAT(packstone_command("check " + scene).output, Contains("way to rest"));
  const auto run = packstone_command("run " + scene + " --quiet -o " + (folder / "run").string());
  CAPTURE(run.output);
  REQUIRE(run.exit_code == 0);
  const auto record = nlohmann::json::parse(read_text_file(folder / "run/run.json"));
  CHECK_THAT(record["ending"].get<std::string>(), StartsWith("at rest") && Contains("steps of relaxation"));
  CHECK(packstone_command("analyze " + (folder / "run").string() + " --only packing --quiet").exit_code == 0);
}
