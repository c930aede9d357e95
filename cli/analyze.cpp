// packstone analyze: measures of snapshots as text, JSON and CSV.

#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/measures.hpp"
#include "analysis/writers.hpp"
#include "cli/progress.hpp"
#include "cli/selection.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/run_folder.hpp"

namespace packstone::cli {

namespace {

struct AnalyzeOptions {
  std::filesystem::path path;
  std::vector<std::string> only;
  std::string at = "last";
  std::filesystem::path json;
  std::filesystem::path csv;
  analysis::Options measure;
  bool list = false;
  bool quiet = false;
};

void write_outputs(const AnalyzeOptions& options, const std::vector<analysis::TimedResults>& series) {
  const bool single = options.at != "all";
  const auto json = single ? analysis::to_json(series.front().results) : analysis::to_json(series);
  if (options.json == "-") {
    fmt::print("{}\n", json.dump(2));
  } else if (!options.json.empty()) {
    analysis::write_json(options.json, json);
  }
  if (options.csv.empty()) return;
  if (single) {
    analysis::write_csv(options.csv, series.front().results);
  } else {
    analysis::write_csv(options.csv, series);
  }
}

void analyze(const AnalyzeOptions& options) {
  if (options.list) {
    for (const auto& measure : analysis::all_measures()) fmt::print("{:<14}{}\n", measure.name, measure.description);
    return;
  }
  if (options.path.empty()) throw InputError("analyze: name a run folder or a snapshot");
  const RunReader run(options.path);
  const auto selected = selected_snapshots(run, options.at);
  std::vector<analysis::TimedResults> series;
  {
    Progress progress("snapshots", options.quiet || selected.size() == 1);
    for (const std::size_t index : selected) {
      const Snapshot snapshot = run.snapshot(index);
      series.push_back({snapshot.time, snapshot.step, analysis::analyze(snapshot, options.only, options.measure)});
      progress.update(static_cast<std::int64_t>(series.size()), static_cast<std::int64_t>(selected.size()));
    }
  }
  write_outputs(options, series);
  if (options.quiet || options.json == "-") return;
  fmt::print("{}  t = {:g} s\n\n{}", run.path().string(), series.back().time, analysis::to_text(series.back().results));
}

}  // namespace

void add_analyze(CLI::App& app) {
  auto options = std::make_shared<AnalyzeOptions>();
  CLI::App* verb = app.add_subcommand("analyze", "Measure packing, structure, segregation, clusters, forces, rest");
  verb->add_option("path", options->path, "Run folder or snapshot");
  verb->add_option("--only", options->only, "Measures to take, by comma; see --list")->delimiter(',');
  verb->add_option("--at", options->at, "last, first, all, a number, or t=SECONDS")->capture_default_str();
  verb->add_option("--json", options->json, "Write JSON to a file; - for standard output");
  verb->add_option("--csv", options->csv, "Write CSV tables into a folder");
  verb->add_option("--profile-layer", options->measure.profile_layer,
                   "Thickness of the vertical profile's layers [m] [one mean radius]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--segregation-layer", options->measure.segregation_layer,
                   "Thickness of the layers of composition and segregation [m] [one mean diameter]")
      ->check(CLI::PositiveNumber);
  verb->add_flag("--list", options->list, "List the measures");
  verb->add_flag("--quiet", options->quiet, "No text and no progress");
  verb->callback([options] { analyze(*options); });
}

}  // namespace packstone::cli
