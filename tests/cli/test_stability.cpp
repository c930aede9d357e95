// Where models fail: the limits that sweeps find beside those of theory, and the monitor's part in it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include <catch2/catch.hpp>

#include "cli/study/stability_map.hpp"
#include "command.hpp"
#include "core/files.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::cli;
using Catch::Matchers::Contains;
using testing::packstone_command;
using testing::TemporaryFolder;

namespace {

const StabilityMap& map_named(const std::string& name) {
  static const std::vector<StabilityMap> all = stability_maps(false);
  return *std::find_if(all.begin(), all.end(), [&](const StabilityMap& map) { return map.name == name; });
}

Outcome outcome_at(const std::string& map, double x, double y) {
  const MapPoint point = point_of(map_named(map), x, y);
  UNSCOPED_INFO(map << " at " << x << ", " << y << ": " << to_string(point.outcome.verdict) << " "
                    << point.outcome.reason);
  return point.outcome;
}

Verdict verdict_at(const std::string& map, double x, double y) { return outcome_at(map, x, y).verdict; }

}  // namespace

TEST_CASE("Every map says what it sweeps, and its first column can be run", "[stability]") {
  std::set<std::string> names;
  for (const StabilityMap& map : stability_maps(true)) {
    CHECK(names.insert(map.name).second);
    CHECK(map.x.size() >= 3);
    CHECK(std::is_sorted(map.x.begin(), map.x.end()));
    CHECK_FALSE(map.limits.empty());
    CHECK_NOTHROW(parse_scene(map.scene(map.x[0], map.y[map.y.size() / 2]), map.name));
  }
  CHECK(names.size() == 16);
}

TEST_CASE("Steps within the recommended one are sound, those beyond 2/omega are refused", "[stability]") {
  const std::string law = GENERATE("linear", "hertz", "kuwabara_kono", "walton_braun");
  const double y = law == "kuwabara_kono" ? 0.1 : 0.5;
  CHECK(verdict_at("step_" + law, 0.04, y) == Verdict::sound);
  CHECK(verdict_at("step_" + law, 0.66, y) == Verdict::refused);
}

TEST_CASE("Between the two limits beds are not what the equations say", "[stability]") {
  CHECK(verdict_at("step_linear", 0.27, 0.5) != Verdict::sound);
  CHECK(verdict_at("step_hysteretic", 0.15, 0.5) != Verdict::sound);
}

TEST_CASE("A sphere on the floor comes to rest where the step is below m w/(g k xi)", "[stability]") {
  const StabilityMap& jitter = map_named("jitter");
  for (const double speed : {1e-5, 1e-4}) {
    const double limit = jitter.limits.front().x_at(speed);
    CHECK(verdict_at("jitter", limit / 1.5, speed) == Verdict::sound);
    CHECK(verdict_at("jitter", limit * 2, speed) == Verdict::disturbed);
  }
}

TEST_CASE("The monitor stops a column where its weight presses beyond the overlap limit", "[stability]") {
  const double spheres = 8, limit = map_named("load").limits.front().x_at(spheres);
  const Outcome pressed = outcome_at("load", 0.7 * limit, spheres);
  CHECK(pressed.verdict == Verdict::stopped);
  CHECK_THAT(pressed.reason, Contains("boundary floor overlap"));
  CHECK(verdict_at("load", 2.5 * limit, spheres) == Verdict::sound);  // put on at once, a load presses twice as deep
}

TEST_CASE("No sphere goes through a thin plate unseen", "[stability]") {
  for (const double speed : {0.02, 0.3, 0.7, 3.0}) {
    for (const double overlap : {0.05, 0.3, 1.0}) CHECK(verdict_at("wall_speed", speed, overlap) != Verdict::disturbed);
  }
  CHECK_THAT(outcome_at("wall_speed", 0.7, 1).reason, Contains("could go through a boundary"));
}

TEST_CASE("Growth too quick, attraction too steep and Euler's steps too long are found out", "[stability]") {
  CHECK(verdict_at("growth", 3, 0.02) == Verdict::stopped);
  CHECK(verdict_at("growth", 1000, 0.02) == Verdict::sound);
  const double steep = map_named("adhesion").limits.front().x_at(1e-3);
  CHECK(verdict_at("adhesion", 2 * steep, 1e-3) != Verdict::sound);
  CHECK(verdict_at("overdamped", 1.1, 300) == Verdict::refused);
  CHECK(verdict_at("overdamped", 0.15, 300) == Verdict::sound);
  CHECK_THAT(outcome_at("overdamped", 0.5, 300).reason, Contains("the motion is unstable"));
}

TEST_CASE("Friction with springs holds a bed on a slope, friction by velocity lets it creep", "[stability]") {
  CHECK(verdict_at("creep_cundall_strack", 0.05, 0.5) == Verdict::sound);
  CHECK(verdict_at("creep_haff_werner", 0.05, 0.5) == Verdict::disturbed);
}

TEST_CASE("stability writes a table and a chart of each map", "[stability]") {
  const TemporaryFolder folder;
  const auto result = packstone_command("stability load --quick --threads 1 --quiet -o " + (folder / "out").string());
  CAPTURE(result.output);
  REQUIRE(result.exit_code == 0);
  const std::string csv = read_text_file(folder / "out/load.csv");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 5 * 3);
  CHECK_THAT(csv, Contains(",stopped,") && Contains(",sound,"));
  CHECK(std::filesystem::file_size(folder / "out/load.png") > 1000);
  const auto list = packstone_command("stability --list");
  CHECK_THAT(list.output, Contains("wall_speed") && Contains("step_linear"));
  const auto wrong = packstone_command("stability lode -o " + (folder / "none").string());
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.output, Contains("did you mean \"load\"?"));
  CHECK_FALSE(std::filesystem::exists(folder / "none"));
}
