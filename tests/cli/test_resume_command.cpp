// Runs that signals and kills end, gone on with as a user would.
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::testing;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// A run of a second or two that one test after the other stops.
struct LongRun {
  TemporaryFolder folder;
  std::string call;

  LongRun() {
    std::ofstream(folder / "a scene.toml") << small_scene;
    call = "run " + quoted(folder / "a scene.toml") +
           " --quiet --set dynamics.duration=0.6 --set output.checkpoint_interval=0.05";
  }
  fs::path path(const std::string& name) const { return folder / name; }
  std::string into(const std::string& name) const { return " -o " + quoted(path(name)); }

  /// Runs into a folder and sends a signal when two checkpoints and some snapshots are there.
  Result stopped_by(const std::string& signal, const std::string& name) const {
    const fs::path run = path(name);
    return shell("{ " + std::string(PACKSTONE_COMMAND) + " " + call + into(name) + " & p=$!; while [ ! -e " +
                 quoted(run / "checkpoint/checkpoint_1") + " -o ! -e " +
                 quoted(run / "snapshots/snapshot_000004.vtkhdf") + " ]; do sleep 0.01; done; kill -" + signal +
                 " $p; wait $p; echo exit code $?; }");
  }
  nlohmann::json info(const std::string& name) const {
    const Result result = packstone_command("info --json " + quoted(path(name)));
    INFO(result.output);
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(result.output);
  }
  void check_same(const std::string& one, const std::string& other) const {
    const auto files = snapshot_files(path(one));
    REQUIRE(files.size() == snapshot_files(path(other)).size());
    REQUIRE(files.size() == 31);
    for (const fs::path& file : files) {
      CHECK((read_text_file(file) == read_text_file(path(other) / "snapshots" / file.filename())));
    }
    CHECK((read_text_file(path(one) / "history.csv") == read_text_file(path(other) / "history.csv")));
  }
};

}  // namespace

TEST_CASE("a run ended by SIGINT, SIGTERM or a kill is gone on with") {
  const LongRun runs;
  REQUIRE(packstone_command(runs.call + runs.into("whole")).exit_code == 0);
  for (const std::string signal : {"INT", "TERM"}) {
    const Result stopped = runs.stopped_by(signal, signal);
    CHECK_THAT(stopped.output, Contains("exit code 130") && Contains("packstone run --resume -o "));
    CHECK(runs.info(signal)["status"] == "interrupted");
    const Result resumed = packstone_command("run --resume" + runs.into(signal));
    CHECK(resumed.exit_code == 0);
    CHECK_THAT(resumed.output, Contains("goes on from checkpoint_"));
    runs.check_same("whole", signal);
  }

  CHECK_THAT(runs.stopped_by("KILL", "killed").output, Contains("exit code 137"));
  nlohmann::json info = runs.info("killed");
  CHECK(info["status"] == "killed");
  CHECK_THAT(std::string(info["reason"]), Contains("is gone"));
  CHECK(info["snapshots"] >= 5);
  CHECK(info["checkpoints"].size() == 2);
  CHECK_THAT(std::string(info["go_on_with"]), Contains("--resume"));
  CHECK(packstone_command(runs.call + runs.into("killed") + " --resume --threads 1").exit_code == 0);
  runs.check_same("whole", "killed");
  info = runs.info("killed");
  CHECK(info["status"] == "finished");
  CHECK_FALSE(info.contains("go_on_with"));

  const Result again = packstone_command("run --resume" + runs.into("killed"));
  CHECK(again.exit_code == 0);
  CHECK_THAT(again.output, Contains("the run is finished"));
}

TEST_CASE("what cannot be gone on with is told in one line") {
  const LongRun runs;
  runs.stopped_by("KILL", "run");
  const auto refused = [](const std::string& arguments, const std::string& what) {
    const Result result = packstone_command(arguments);
    INFO(result.output);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.output, Contains(what));
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
  };
  refused(runs.call + runs.into("run") + " --resume --set seed=9", "differs in seed");
  refused("run --resume" + runs.into("nothing"), "no whole checkpoint");
  refused("run --resume", "name a scene");
  refused("run", "name a scene");
  refused(runs.call + runs.into("run"), "--resume");
  refused(runs.call + runs.into("run") + " --resume --overwrite", "--overwrite");
  for (const char* file : {"checkpoint_0", "checkpoint_1"}) fs::resize_file(runs.path("run/checkpoint") / file, 50);
  refused(runs.call + runs.into("run") + " --resume", "cut short");
  const nlohmann::json info = runs.info("run");
  CHECK(info["of_no_use"].size() == 2);
  CHECK_FALSE(info.contains("go_on_with"));
}

TEST_CASE("info tells what a damaged folder still holds") {
  const LongRun runs;
  runs.stopped_by("KILL", "run");
  const fs::path run = runs.path("run");
  const auto files = snapshot_files(run);
  fs::resize_file(files[1], fs::file_size(files[1]) / 2);
  fs::resize_file(files.back(), 0);
  fs::resize_file(run / "history.csv", fs::file_size(run / "history.csv") - 3);
  fs::resize_file(run / "run.json", 20);
  nlohmann::json info = runs.info("run");
  CHECK(info["status"] == "unknown");
  CHECK(info["snapshots"] == files.size() - 2);
  CHECK(info["history"]["rows"] > 10);
  for (const std::string& file :
       {files[1].filename().string(), files.back().filename().string(), std::string("run.json")}) {
    CHECK(info["of_no_use"].contains(file));
  }
  CHECK(info["last_snapshot"]["particles"] == 120);
  CHECK(packstone_command("info " + quoted(run)).exit_code == 0);
  fs::remove(run / "run.json");
  info = runs.info("run");
  CHECK_THAT(std::string(info["of_no_use"]["run.json"]), Contains("no such file"));
}
