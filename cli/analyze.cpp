// packstone analyze: measures of snapshots as text, JSON and CSV.

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/layers.hpp"
#include "analysis/measures.hpp"
#include "analysis/packing/fraction_map.hpp"
#include "analysis/packing/region.hpp"
#include "analysis/series.hpp"
#include "analysis/time/course.hpp"
#include "analysis/writers.hpp"
#include "cli/comparison.hpp"
#include "cli/progress.hpp"
#include "cli/selection.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
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
  std::vector<std::string> regions;
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

void analyze_one(const AnalyzeOptions& options) {
  const bool whole_series = options.at == "all";
  if (whole_series && !options.map.empty()) throw InputError("--map takes one instant; --at all has several");
  const RunReader run(options.paths.front());
  const auto series = measured(run, options);
  put_json(options.json, whole_series ? analysis::to_json(series) : analysis::to_json(series.front().results));
  if (!options.csv.empty() && whole_series) analysis::write_csv(options.csv, series);
  if (!options.csv.empty() && !whole_series) analysis::write_csv(options.csv, series.front().results);
  if (!options.map.empty()) {
    analysis::write_fraction_map(options.map, run.snapshot(selected_snapshots(run, options.at).front()),
                                 options.measure);
  }
  if (options.quiet || options.json == "-") return;
  fmt::print("{}  t = {:g} s\n", run.path().string(), series.back().time);
  for (const std::string& note : series.back().notes) fmt::print("note: {}\n", note);
  fmt::print("\n{}", analysis::to_text(series.back().results));
}

void analyze_several(const AnalyzeOptions& options) {
  if (options.at == "all") throw InputError("--at all takes one run; several runs are compared at one instant each");
  if (!options.csv.empty()) throw InputError("--csv takes one run; several runs are compared as text or --json");
  if (!options.map.empty()) throw InputError("--map takes one run");
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

void analyze(AnalyzeOptions& options) {
  for (const auto& text : options.regions) options.measure.regions.push_back(analysis::parse_region(text));
  if (options.list) {
    for (const auto& measure : analysis::all_measures()) {
      fmt::print("{:<14}{}{}\n", measure.name, measure.description, measure.on_request ? " (takes long: name it)" : "");
    }
    fmt::print("{:<14}{}\n", analysis::course_name, analysis::course_description);
  } else if (options.paths.empty()) {
    throw InputError("analyze: name a run folder or a file");
  } else if (options.paths.size() == 1) {
    analyze_one(options);
  } else {
    analyze_several(options);
  }
}

void add_force_options(CLI::App& verb, analysis::ForceOptions& forces) {
  verb.add_option("--chain-threshold", forces.chain_threshold, "Stress of particles in force chains, in means")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb.add_option("--chain-angle", forces.chain_angle, "Largest angle of a chain to its particles' stress [degrees]")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str();
  verb.add_option("--kernel", forces.kernel, "Kernel of coarse-grained fields: lucy or gaussian [lucy]")
      ->transform(CLI::CheckedTransformer(std::map<std::string, analysis::Kernel>{
          {"lucy", analysis::Kernel::lucy}, {"gaussian", analysis::Kernel::gaussian}}));
  verb.add_option("--kernel-width", forces.kernel_width,
                  "Standard deviation of that kernel along an axis [m] [one mean radius]")
      ->check(CLI::PositiveNumber);
  verb.add_option("--community-resolution", forces.resolution, "Larger values give smaller communities")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

}  // namespace

void add_analyze(CLI::App& app) {
  using analysis::AlongAxis, analysis::ShareBy;
  auto options = std::make_shared<AnalyzeOptions>();
  CLI::App* verb = app.add_subcommand("analyze", "Measure packing, structure, segregation, clusters, forces, rest");
  verb->add_option("paths", options->paths,
                   "Run folder, snapshot, or a file of another program; several are compared in a table");
  verb->add_option("--only", options->only, "Measures to take, by comma; see --list [all but those that take long]")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--at", options->at, "last, first, all, a number, or t=SECONDS")->capture_default_str();
  verb->add_option("--json", options->json, "Write JSON to a file; - for standard output");
  verb->add_option("--csv", options->csv, "Write CSV tables into a folder");
  verb->add_option("--profile-layer", options->measure.profile_layer,
                   "Thickness of the vertical profile's layers [m] [one mean radius]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--segregation-layer", options->measure.segregation_layer,
                   "Thickness of the layers of composition and segregation [m] [one mean diameter]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--cluster-gap", options->measure.clusters.gap,
                   "Clusters of particles whose surfaces are nearer than this [m] [contacts]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--cluster-force", options->measure.clusters.least_force,
                   "Clusters of contacts that press by more than so many mean normal forces")
      ->check(CLI::PositiveNumber);
  verb->add_flag("--cluster-any-type", options->measure.clusters.any_type, "Clusters of any types, not of like ones");
  verb->add_option("--trajectories", options->trajectories, "With --at all: ids of particles to follow, by comma")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--wall-layer", options->measure.wall_layer,
                   "Width of the rings and shells of the profiles from the side walls [m] [one mean radius]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--interior-margin", options->measure.interior_margin,
                   "Distance of the interior from walls, floor and surface, in mean diameters weighted by volume")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_option("--region", options->regions,
                   "Region whose solid fraction to measure, again for more: box:x0,y0,z0,x1,y1,z1; "
                   "slab:AXIS,lower,upper; sphere:x,y,z,radius; cylinder:AXIS,u,v,lower,upper,radius; "
                   "ring:AXIS,u,v,lower,upper,inner,outer; u, v: the axis' place in the other two coordinates")
      ->allow_extra_args(false);
  verb->add_option("--map", options->map, "Write the local solid fraction on a grid to FILE.vti");
  verb->add_option("--map-cell", options->measure.map_cell,
                   "Width of the map's cells [m] [one mean diameter weighted by volume]")
      ->check(CLI::PositiveNumber);
  add_force_options(*verb, options->measure.forces);
  verb->add_option("--segregation-cells", options->measure.segregation_cell,
                   "Edge of the cells of segregation [m] [three mean diameters]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--segregation-rings", options->measure.segregation_rings,
                   "Number of rings of segregation about the axis [outermost one diameter wide]")
      ->check(CLI::Range(2, static_cast<int>(analysis::most_layers)));
  verb->add_option("--segregation-by", options->measure.segregation_by, "Shares by number, volume or mass [volume]")
      ->transform(CLI::CheckedTransformer(std::map<std::string, ShareBy>{
          {"number", ShareBy::number}, {"volume", ShareBy::volume}, {"mass", ShareBy::mass}}));
  verb->add_option("--segregation-axis", options->measure.segregation_axis,
                   "Axis of the layers and rings of segregation: up, x, y or z [up]")
      ->transform(CLI::CheckedTransformer(std::map<std::string, AlongAxis>{
          {"up", AlongAxis::up}, {"x", AlongAxis::x}, {"y", AlongAxis::y}, {"z", AlongAxis::z}}));
  verb->add_option("--rdf-range", options->measure.rdf_range,
                   "Range of the radial distribution function [m] [five mean diameters]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--rdf-bin", options->measure.rdf_bin, "Width of its bins [m] [a twentieth of the mean diameter]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--bond-cutoff", options->measure.bond_cutoff,
                   "Bond order: neighbours have centres nearer than so many sums of radii")
      ->capture_default_str();
  verb->add_option("--bond-neighbours", options->measure.bond_neighbours,
                   "Bond order: so many nearest neighbours instead [by cut-off]")
      ->check(CLI::PositiveNumber);
  verb->add_option("--pore-points", options->measure.pore_points, "Random points for the pore sizes")
      ->capture_default_str();
  verb->add_flag("--voronoi-cells", options->measure.voronoi_cells,
                 "Measure voronoi also lists the cell of every particle");
  verb->add_flag("--list", options->list, "List the measures");
  verb->add_flag("--quiet", options->quiet, "No text and no progress");
  verb->callback([options] { analyze(*options); });
}

}  // namespace packstone::cli
