// packstone stability: where models and steps fail, as maps with what theory says drawn in.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <omp.h>

#include "cli/interrupt.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "cli/study/stability_map.hpp"
#include "cli/study/stability_report.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

struct StabilityOptions {
  std::vector<std::string> maps;
  fs::path output = "stability";
  std::string format = "png";
  int threads = 0;
  FigureCall figure;
  bool quick = false;
  bool list = false;
  bool quiet = false;
};

std::vector<StabilityMap> chosen_maps(const StabilityOptions& options) {
  const std::vector<StabilityMap> all = stability_maps(options.quick);
  if (options.maps.empty()) return all;
  std::vector<std::string> names;
  for (const StabilityMap& map : all) names.push_back(map.name);
  std::vector<StabilityMap> chosen;
  for (const std::string& name : options.maps) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      const auto near = nearest_name(name, names);
      throw InputError(fmt::format("no map \"{}\"; {}", name,
                                   near ? fmt::format("did you mean \"{}\"?", *near) : "there are " + joined(names)));
    }
    chosen.push_back(all[found - names.begin()]);
  }
  return chosen;
}

/// The runs are small: one a thread.
std::vector<MapPoint> points_of(const StabilityMap& map, bool quiet) {
  std::vector<MapPoint> points(map.x.size() * map.y.size());
  Progress progress(map.name, quiet);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  std::int64_t done = 0;
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    if (interrupted()) continue;
    points[k] = point_of(map, map.x[k % map.x.size()], map.y[k / map.x.size()]);
#pragma omp critical
    progress.update(++done, count);
  }
  if (interrupted()) throw Interrupted("stopped within the map " + map.name);
  return points;
}

void stability(StabilityOptions options) {
  const auto maps = chosen_maps(options);
  if (options.list) {
    for (const StabilityMap& map : maps) fmt::print("{:<20}{}\n", map.name, map.description);
    return;
  }
  catch_interrupts();
  if (options.threads > 0) omp_set_num_threads(options.threads);
  omp_set_max_active_levels(1);
  const OutputFolder folder(options.output);
  for (const StabilityMap& map : maps) {
    const auto points = points_of(map, options.quiet);
    write_csv(options.output / (map.name + ".csv"), map, points);
    viz::Chart chart = stability_chart(map, points);
    take_size(options.figure, chart.options);
    save_figure(options.output / (map.name + "." + options.format), viz::chart_drawing(chart), options.figure,
                chart.options.supersampling, chart.options.title);
    if (!options.quiet) fmt::print("{:<20}{}\n", map.name, tally(points));
  }
}

}  // namespace

void add_stability(Program& program) {
  auto options = std::make_shared<StabilityOptions>();
  options->figure.size = "1600x1000";
  Verb verb = program.add_verb(stability_verb.name, stability_verb.description);
  verb.add("maps", options->maps, "Maps, see --list [all]");
  verb.add("-o,--output", options->output, "Folder for a table and a chart of each").shows_default();
  verb.add_flag("--list", options->list, "List the maps");
  verb.add_flag("--quick", options->quick, "Every other column and row");
  verb.add("--threads", options->threads, "Runs at a time [all cores]").between(1, 1024);
  verb.add("--format", options->format, "Of the charts").one_of({"png", "svg", "pdf"}).shows_default();
  add_figure_options(verb, options->figure);
  verb.add_flag("--quiet", options->quiet, "No text and no progress");
  verb.set_action([options] { stability(*options); });
}

}  // namespace packstone::cli
