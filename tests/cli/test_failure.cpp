// A run that is stopped, from the outside: exit code, one line, the verdict in parts, the failing state.
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
using nlohmann::json;
using testing::packstone_command;
using testing::quoted;
using testing::small_scene;
using testing::TemporaryFolder;

namespace {

/// small_scene, of which heavy particles that fall would press into soft ones.
struct StoppedRun {
  TemporaryFolder folder;
  std::string path;
  testing::Result result;

  StoppedRun() {
    std::ofstream(folder / "scene.toml") << small_scene;
    path = (folder / "run").string();
    result = run("--set material[0].normal_stiffness=2e3 --set material[1].normal_stiffness=2e3");
  }
  testing::Result run(const std::string& options) const {
    return packstone_command("run " + quoted(folder / "scene.toml") + " --quiet --threads 1 --overwrite " + options +
                             " -o " + path);
  }
};

}  // namespace

TEST_CASE("a run that is stopped has exit code 1, one line, and its verdict in parts", "[failure]") {
  const StoppedRun run;
  INFO(run.result.output);
  CHECK(run.result.exit_code == 1);
  CHECK(std::count(run.result.output.begin(), run.result.output.end(), '\n') == 1);
  CHECK_THAT(run.result.output, StartsWith("packstone: error: t = ") && Contains("monitor.overlap_limit = 5 %"));
  const auto told = packstone_command("info --json " + run.path);
  REQUIRE(told.exit_code == 0);
  const json info = json::parse(told.output);
  CHECK(info["status"] == "failed");
  CHECK(info["failing_state"] == "failure.vtkhdf");
  const json& failure = info["failure"];
  CHECK(failure["kind"] == "overlap");
  CHECK(failure["limit"] == 0.05);
  CHECK(failure["value"] > 0.05);
  CHECK(failure["place"].size() == 3);
  CHECK(failure["particles"].size() + failure["boundaries"].size() >= 2);
  CHECK(failure["change"].size() >= 2);
  const auto text = packstone_command("info " + run.path);
  CHECK_THAT(text.output, Contains("failure") && Contains("kind            overlap"));
  const auto of_state = packstone_command("info " + run.path + "/failure.vtkhdf");
  CHECK(of_state.exit_code == 0);
  CHECK_THAT(of_state.output, Contains("offender") && Contains("run was stopped"));
}

TEST_CASE("measures leave the failing state aside, and a new run in the folder takes it away", "[failure]") {
  const StoppedRun run;
  const std::size_t snapshots = RunReader(run.path).snapshot_count();
  REQUIRE(snapshots > 0);
  const auto measured =
      packstone_command("analyze " + run.path + " --at all --only packing --json " + quoted(run.folder / "m.json"));
  INFO(measured.output);
  CHECK(measured.exit_code == 0);
  CHECK_THAT(read_text_file(run.folder / "m.json"), !Contains("run was stopped"));
  REQUIRE(run.run("").exit_code == 0);
  CHECK_FALSE(std::filesystem::exists(run.path + "/failure.vtkhdf"));
  CHECK(packstone_command("info " + run.path).output.find("failure") == std::string::npos);
}

#ifdef PACKSTONE_PICTURES
TEST_CASE("render shows the failing state with the offenders marked", "[failure]") {
  const StoppedRun run;
  const std::string look = " --size 320x240 --supersampling 1 --quiet -o ";
  const auto picture = [&](const std::string& call, const std::string& name) {
    const auto done = packstone_command("render " + run.path + call + look + quoted(run.folder / name));
    INFO(done.output);
    REQUIRE(done.exit_code == 0);
    const std::string file = read_text_file(run.folder / name);
    return file.substr(file.find("IDAT"));
  };
  const std::string own = picture(" --failure", "a.png");
  CHECK((picture("/failure.vtkhdf", "b.png") == own));
  const RunVerdict verdict = *RunReader(run.path).record().failure;
  std::string ids;
  for (const auto* group : {&verdict.particles, &verdict.touching}) {
    for (const NamedParticle& p : *group) ids += (ids.empty() ? "" : ",") + std::to_string(p.id);
  }
  CHECK((picture("/failure.vtkhdf --color offender --particles shrunk --trajectories " + ids, "c.png") == own));
  CHECK_FALSE((picture("/failure.vtkhdf --color type", "d.png") == own));
  REQUIRE(run.run("").exit_code == 0);
  const auto none = packstone_command("render " + run.path + " --failure" + look + quoted(run.folder / "e.png"));
  CHECK(none.exit_code == 2);
  CHECK_THAT(none.output, Contains("was not stopped"));
}
#endif
