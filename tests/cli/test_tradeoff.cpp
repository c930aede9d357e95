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
