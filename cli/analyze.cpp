// packstone analyze: measures of snapshots as text, JSON and CSV.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/forces/coarse_grid.hpp"
#include "analysis/measures.hpp"
#include "analysis/packing/fraction_map.hpp"
#include "analysis/particle_fields.hpp"
#include "analysis/series.hpp"
#include "analysis/surface/surface_file.hpp"
#include "analysis/time/course.hpp"
#include "analysis/writers.hpp"
#include "cli/comparison.hpp"
#include "cli/measure_options.hpp"
#include "cli/progress.hpp"
#include "cli/selection.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"

namespace packstone::cli {

namespace {

struct AnalyzeOptions {
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> only;
  std::string at = "last";
  std::filesystem::path json;
  std::filesystem::path csv;
  std::filesystem::path map;
  std::filesystem::path coarse;
  std::filesystem::path particles;
  std::filesystem::path surface;
  analysis::Options measure;
  std::vector<std::int64_t> trajectories;
  bool list = false;
  bool quiet = false;
};

void put_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  if (path == "-") {
    fmt::print("{}\n", json.dump(2));
  } else if (!path.empty()) {
    analysis::write_json(path, json);
  }
}

std::vector<analysis::TimedResults> measured(const RunReader& run, const AnalyzeOptions& options) {
  const auto selected = selected_snapshots(run, options.at);
  Progress progress("snapshots", options.quiet || selected.size() == 1);
  analysis::SeriesOptions series{options.only, options.measure, options.trajectories};
  series.progress = [&](std::size_t done) {
    progress.update(static_cast<std::int64_t>(done), static_cast<std::int64_t>(selected.size()));
  };
  return analysis::analyze_series(run, selected, series);
}

/// The options that each name a file of one instant.
std::vector<std::pair<const char*, std::filesystem::path>> files_of_one_instant(const AnalyzeOptions& options) {
  return {{"--map", options.map},
          {"--coarse", options.coarse},
          {"--surface", options.surface},
          {"--particles", options.particles}};
}

/// Before the work, so that it is not in vain.
void check_outputs(const AnalyzeOptions& options) {
  auto files = files_of_one_instant(options);
  if (options.json != "-") files.emplace_back("--json", options.json);
  for (const auto& [name, path] : files) {
    if (!path.empty()) check_writable(path);
  }
}

/// What is missing from them, a sentence each.
std::vector<std::string> write_files_of_one_instant(const RunReader& run, const AnalyzeOptions& options) {
  std::vector<std::string> missing;
  const auto files = files_of_one_instant(options);
  if (std::all_of(files.begin(), files.end(), [](const auto& file) { return file.second.empty(); })) return missing;
  const Snapshot snapshot = run.snapshot(selected_snapshots(run, options.at).front());
  if (!options.map.empty()) analysis::write_fraction_map(options.map, snapshot, options.measure);
  if (!options.coarse.empty()) analysis::write_coarse_fields(options.coarse, snapshot, options.measure);
  if (!options.surface.empty()) analysis::write_surface(options.surface, snapshot, options.measure);
  if (options.particles.empty()) return missing;
  const auto fields = analysis::particle_fields(snapshot, options.only, options.measure);
  analysis::write_particles(options.particles, snapshot, fields);
  for (const auto& field : fields) {
    if (!field.missing.empty()) missing.push_back(fmt::format("particles without {}: {}", field.name, field.missing));
  }
  return missing;
}

void analyze_one(const AnalyzeOptions& options) {
  const bool whole_series = options.at == "all";
  for (const auto& [name, path] : files_of_one_instant(options)) {
    if (whole_series && !path.empty())
      throw InputError(fmt::format("{} takes one instant; --at all has several", name));
  }
  if (!options.particles.empty()) analysis::require_particle_format(options.particles);  // before the work
  const RunReader run(options.paths.front());
  const auto series = measured(run, options);
  put_json(options.json, whole_series ? analysis::to_json(series) : analysis::to_json(series.front().results));
  if (!options.csv.empty() && whole_series) analysis::write_csv(options.csv, series);
  if (!options.csv.empty() && !whole_series) analysis::write_csv(options.csv, series.front().results);
  const auto missing = write_files_of_one_instant(run, options);
  if (options.quiet || options.json == "-") return;
  fmt::print("{}  t = {:g} s\n", run.path().string(), series.back().time);
  for (const std::string& note : series.back().notes) fmt::print("note: {}\n", note);
  for (const std::string& note : missing) fmt::print("note: {}\n", note);
  fmt::print("\n{}", analysis::to_text(series.back().results));
}

void analyze_several(const AnalyzeOptions& options) {
  if (options.at == "all") throw InputError("--at all takes one run; several runs are compared at one instant each");
  if (!options.csv.empty()) throw InputError("--csv takes one run; several runs are compared as text or --json");
  for (const auto& [name, path] : files_of_one_instant(options)) {
    if (!path.empty()) throw InputError(fmt::format("{} takes one run", name));
  }
  std::vector<std::string> labels;
  std::vector<std::vector<analysis::MeasureResult>> results;
  auto json = nlohmann::ordered_json::array();
  for (const auto& path : options.paths) {
    const RunReader run(path);
    const auto instant = measured(run, options).front();
    labels.push_back(fmt::format("{}, t = {:g} s", path.string(), instant.time));
    results.push_back(instant.results);
    json.push_back({{"path", path.string()}, {"measures", analysis::to_json(instant.results)}});
  }
  put_json(options.json, json);
  if (!options.quiet && options.json != "-") fmt::print("{}", to_markdown(compare(labels, results)));
}

/// With what they know of every particle, as any snapshot has it.
void list_measures(const AnalyzeOptions& options) {
  for (const auto& measure : analysis::all_measures()) {
    fmt::print("{:<14}{}{}\n", measure.name, measure.description, measure.on_request ? " (takes long: name it)" : "");
  }
  fmt::print("{:<14}{}\n", analysis::course_name, analysis::course_description);
  fmt::print("\nof every particle, with --particles:\n");
  for (const auto& measure : analysis::all_measures()) {
    if (!measure.fields) continue;
    fmt::print("{}\n", measure.name);
    for (const auto& field : analysis::particle_fields(Snapshot{}, {measure.name}, options.measure)) {
      fmt::print("  {:<24}{}{}\n", field.name, field.unit.empty() ? "" : "[" + field.unit + "] ", field.definition);
    }
  }
}

void analyze(const AnalyzeOptions& options) {
  check_outputs(options);
  if (options.list) {
    list_measures(options);
  } else if (options.paths.empty()) {
    throw InputError("analyze: name a run folder or a file");
  } else if (options.paths.size() == 1) {
    analyze_one(options);
  } else {
    analyze_several(options);
  }
}

}  // namespace

void add_analyze(Program& program) {
  auto options = std::make_shared<AnalyzeOptions>();
  Verb verb = program.add_verb("analyze", "Measure packing, structure, segregation, clusters, forces, rest");
  verb.add("paths", options->paths,
           "Run folder, snapshot, or a file of another program; several are compared in a table");
  verb.add("--only", options->only, "Measures to take, by comma; see --list [all but those that take long]").by_comma();
  verb.add("--at", options->at, "last, first, all, a number, or t=SECONDS").shows_default();
  verb.add("--json", options->json, "Write JSON to a file; - for standard output");
  verb.add("--csv", options->csv, "Write CSV tables into a folder");
  verb.add("--particles", options->particles,
           fmt::format("Write the particles with what the measures know of each (--list) to {}",
                       analysis::particle_formats));
  verb.add("--coarse", options->coarse, "Write coarse-grained density, velocity and stress on a grid to FILE.vti");
  verb.add("--map", options->map, "Write the local solid fraction on a grid to FILE.vti");
  verb.add("--surface", options->surface, "Write the free surface as triangles to FILE.vtp");
  verb.add("--trajectories", options->trajectories, "With --at all: ids of particles to follow, by comma").by_comma();
  verb.add_flag("--list", options->list, "List the measures");
  verb.add_flag("--quiet", options->quiet, "No text and no progress");
  add_measure_options(verb, options->measure);
  verb.set_action([options] { analyze(*options); });
}

}  // namespace packstone::cli
