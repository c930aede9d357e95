// Error against cost: the arithmetic on made-up trials, the verb on a small scene.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "cli/study/tradeoff_table.hpp"
#include "command.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "small_run.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::cli;
using Catch::Matchers::Contains;
using testing::packstone_command;
using testing::TemporaryFolder;

namespace {

Trial finished_trial(double seconds, double value) { return {true, "", seconds, 100, {{"m.q", value}}}; }

/// A true value of 10 with the same noise of each seed in all variants, but for the last two.
std::vector<VariantTrials> made_up() {
  return {{"dear", "", {finished_trial(100, 10.0), finished_trial(100, 10.2), finished_trial(100, 9.8)}},
          {"near", "", {finished_trial(20, 10.1), finished_trial(22, 10.3), finished_trial(24, 9.9)}},
          {"poor", "", {finished_trial(50, 11.0), finished_trial(50, 11.2), finished_trial(50, 10.8)}},
          {"noisy", "", {finished_trial(1, 10.9), finished_trial(1, 9.9), finished_trial(1, 9.3)}},
          {"broken", "", {finished_trial(1, 10), {false, "lost", 1, 1, {}}, finished_trial(1, 10)}},
          {"absent", "not in this scene", {}}};
}

const TradeoffRow& row_named(const Tradeoff& tradeoff, const std::string& label) {
  return *std::find_if(tradeoff.rows.begin(), tradeoff.rows.end(), [&](const auto& r) { return r.label == label; });
}

}  // namespace

TEST_CASE("Errors of variants are told from the noise of seeds", "[tradeoff]") {
  const Tradeoff result = tradeoff_of(made_up(), {"m.q"}, "");
  CHECK(result.reference == "dear");
  const TradeoffRow &near = row_named(result, "near"), &noisy = row_named(result, "noisy");
  CHECK(near.seconds == Approx(22));
  CHECK(near.accuracy.at("m.q").mean == Approx(10.1));
  CHECK(near.accuracy.at("m.q").spread == Approx(0.2));
  CHECK(near.accuracy.at("m.q").error == Approx(0.1));
  // Seed by seed the difference is always 0.1.
  CHECK(near.accuracy.at("m.q").standard_error == Approx(0).margin(1e-12));
  CHECK(near.accuracy.at("m.q").measured);
  // Differences 0.9, -0.3, -0.5: mean 1/30, deviation sqrt(1.1467/2).
  CHECK(noisy.accuracy.at("m.q").error == Approx(1.0 / 30));
  CHECK(noisy.accuracy.at("m.q").standard_error == Approx(std::sqrt(1.14666667 / 2 / 3)));
  CHECK_FALSE(noisy.accuracy.at("m.q").measured);
  CHECK(row_named(result, "broken").failure == "lost");
  CHECK(row_named(result, "broken").accuracy.empty());
  CHECK(row_named(result, "absent").failure == "not in this scene");
}

TEST_CASE("The error of one estimate does not average away", "[tradeoff]") {
  const Tradeoff result = tradeoff_of(made_up(), {"m.q"}, "dear", Deviation::of_one);
  const Accuracy& noisy = row_named(result, "noisy").accuracy.at("m.q");
  // Differences 0.9, -0.3, -0.5: mean of absolute values 1.7/3, deviation sqrt(0.1867/2).
  CHECK(noisy.error == Approx(1.7 / 3));
  CHECK(noisy.standard_error == Approx(std::sqrt(0.18666667 / 2 / 3)));
  CHECK(noisy.measured);
}

TEST_CASE("The front holds what nothing cheaper is as near as", "[tradeoff]") {
  const Tradeoff result = tradeoff_of(made_up(), {"m.q"}, "dear");
  CHECK(row_named(result, "near").on_front.at("m.q"));
  CHECK(row_named(result, "noisy").on_front.at("m.q"));
  CHECK_FALSE(row_named(result, "poor").on_front.at("m.q"));
  CHECK(row_named(result, "dear").on_front.at("m.q"));
}

TEST_CASE("The cheapest variant is recommended that is sure to be near enough", "[tradeoff]") {
  const Tradeoff result = tradeoff_of(made_up(), {"m.q"}, "");
  CHECK(result.cheapest({{"m.q", 2.0}})->label == "noisy");
  CHECK(result.cheapest({{"m.q", 0.5}})->label == "near");
  CHECK(result.cheapest({{"m.q", 0.05}})->label == "dear");
  CHECK(result.cheapest({{"m.other", 1.0}}) == nullptr);
}

TEST_CASE("A reference must be there and have finished", "[tradeoff]") {
  CHECK_THROWS_WITH(tradeoff_of(made_up(), {"m.q"}, "deer"), Contains("no variant \"deer\"") && Contains("\"dear\""));
  CHECK_THROWS_AS(tradeoff_of(made_up(), {"m.q"}, "broken"), RunError);
}

TEST_CASE("tradeoff runs variants, keeps them, and recommends", "[tradeoff]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const std::string call = "tradeoff " + (folder / "scene.toml").string() + " --seeds 2 --threads 1 -o " +
                           (folder / "out").string() + " --set dynamics.time_step=auto --set monitor.overlap_limit=0.3";
  const std::string variants = " --vary step=0.5,1 --vary 'soft: stiffness=0.1; dynamics.precision=\"mixed\"'";
  const auto result = packstone_command(call + variants + " --tolerance packing_fraction=0.9 --reference 'step 0.5'");
  CAPTURE(result.output);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.output, Contains("within 0.9: \"") && Contains("errors beside \"step 0.5\""));
  for (const char* file :
       {"tradeoff.csv", "tradeoff.md", "packing.bulk_fraction.png", "structure.coordination_mean.png"})
    CHECK(std::filesystem::file_size(folder / "out" / file) > 100);
  const std::string csv = read_text_file(folder / "out/tradeoff.csv");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 4 * 2);
  CHECK_THAT(csv, Contains("\"soft\",packing.bulk_fraction,"));

  // The same call again finds its runs; "as is" and "step 1" are the same motion and the same bed.
  const auto again = packstone_command(call + variants + " --reference 'as is' --format svg");
  REQUIRE(again.exit_code == 0);
  CHECK_THAT(again.output, Contains("| step 1 |"));
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "out/runs"), {}) == 2 * 4);
  CHECK(std::filesystem::exists(folder / "out/packing.bulk_fraction.svg"));
}

TEST_CASE("A wrong call of tradeoff ends in one line, and nothing is run", "[tradeoff]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "scene.toml") << testing::small_scene;
  const auto refused = [&](const std::string& further, const std::string& why) {
    const auto result = packstone_command("tradeoff " + (folder / "scene.toml").string() + " -o " +
                                          (folder / "out").string() + " " + further);
    CAPTURE(further, result.output);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.output, Contains(why));
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
  };
  refused("--tolerance packing_fraction", "QUANTITY=NUMBER");
  refused("--tolerance packing_fractio=0.1", "did you mean \"packing_fraction\"?");
  refused("--measure pakking.bulk_fraction", "packing");
  refused("--vary stiffness=soft", "is no factor");
  refused("--vary nonsense", "is no variant");
  refused("--vary dynamics.nonsense=1", "dynamics.nonsense");
  refused("--seeds 0", "seeds");
}

TEST_CASE("tradeoff of a packing's fraction measures it by points and voxels beside exact volumes", "[tradeoff]") {
  const testing::SmallRun run;
  const auto result =
      packstone_command("tradeoff " + run.path + " --seeds 4 --quiet -o " + (run.folder / "out").string() +
                        " --vary points=200,20000 --vary voxels=0.2" + " --tolerance packing_fraction=0.05");
  CAPTURE(result.output);
  REQUIRE(result.exit_code == 0);
  const std::string table = read_text_file(run.folder / "out/tradeoff.md");
  CHECK_THAT(table, Contains("errors beside \"exact\"") && Contains("| voxels 0.2 |"));
  CHECK_THAT(table, Contains("within 0.05: \""));
  CHECK_THAT(table, !Contains("particle steps") && !Contains("memory"));
  CHECK(std::filesystem::file_size(run.folder / "out/packing.bulk_fraction.png") > 100);
}

TEST_CASE("tradeoff of a surface compares distances of its columns", "[tradeoff]") {
  const testing::SmallRun run;
  const auto result =
      packstone_command("tradeoff " + run.path + " --seeds 2 --measure surface.surface_volume -o " +
                        (run.folder / "out").string() + " --vary columns=1,0.5,0.1 --reference 'columns 0.1'");
  CAPTURE(result.output);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.output, Contains("surface.surface_volume [m3]") && Contains("| columns 1 |"));
}

TEST_CASE("tradeoff of pictures: samples make an error, culling and parts none, occlusion is its own look",
          "[tradeoff]") {
  const testing::SmallRun run;
  const auto result = packstone_command(
      "tradeoff " + run.path + " --picture --picture-size 160x120 --seeds 2 -o " + (run.folder / "out").string() +
      " --vary supersampling=1,4 --vary 'no culling: cull=off' --vary 'parts: parts=2'" +
      " --vary 'dark, 4 samples: occlusion=1; supersampling=4'" + " --tolerance difference=100");
  CAPTURE(result.output);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(result.output, Contains("\"no culling\" draws the same bytes as \"as is\""));
  CHECK_THAT(result.output, Contains("\"parts\" draws the same bytes as \"as is\""));
  CHECK_THAT(result.output, !Contains("\"dark, 4 samples\" draws the same"));
  CHECK_THAT(result.output, Contains("memory [GB]") && Contains("errors beside \"supersampling 4\""));
  const std::string csv = read_text_file(run.folder / "out/tradeoff.csv");
  // Errors: of the finest 0, of the finest of the other look, too.
  const auto error_of = [&](const std::string& label) {
    std::string row = csv.substr(csv.find("\"" + label + "\",picture.difference"));
    row = row.substr(row.find("picture.difference"), row.find('\n'));
    for (int column = 0; column < 6; ++column) row.erase(0, row.find(',') + 1);
    return std::stod(row);
  };
  CHECK(error_of("supersampling 4") == 0);
  CHECK(error_of("dark, 4 samples") == 0);
  CHECK(error_of("supersampling 1") > error_of("as is"));
  CHECK(error_of("as is") > 0);
  CHECK(std::filesystem::exists(run.folder / "out/picture.difference.png"));
}

TEST_CASE("A wrong call of tradeoff of a packing ends in one line", "[tradeoff]") {
  const testing::SmallRun run;
  const auto refused = [&](const std::string& further, const std::string& why) {
    const auto result =
        packstone_command("tradeoff " + run.path + " -o " + (run.folder / "out").string() + " " + further);
    CAPTURE(further, result.output);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.output, Contains(why));
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(run.folder / "out"));
  };
  refused("--measure lacey", "in one way alone");
  refused("--measure packing_fraction,surface.surface_volume", "one quantity at a time");
  refused("--set seed=2", "of a scene");
  refused("--vary pionts=100", "is no way to measure");
  refused("--vary points=many", "is no factor");
  refused("--picture --vary supersampling=1.5", "a whole number");
  refused("--picture --vary cull=maybe", "on or off");
  refused("--picture --vary samples=2", "is nothing a picture is drawn by");
  refused("--picture --measure lacey", "goes without --picture");
  refused("--picture --tolerance packing_fraction=0.1", "the only one");
}
