// packstone plot: charts of one or several runs.

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "cli/charts.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/output_folder.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  std::vector<fs::path> paths;
  std::vector<std::string> what;
  fs::path output;
  FigureCall figure;
  std::string title;
};

struct Plot {
  std::string name;
  viz::Drawing drawing;
  int supersampling = 1;
  std::string title;
};

Plot plot_named(const std::string& name, const PlotOptions& options, const std::vector<RunReader>& runs) {
  viz::Chart chart = make_chart(name, runs);
  take_size(options.figure, chart.options);
  if (!options.title.empty()) chart.options.title = options.title == "-" ? "" : options.title;
  return {name, viz::chart_drawing(chart), chart.options.supersampling, chart.options.title};
}

/// One chart into the file; several, or one where no file is named, into a folder as NAME.png.
void plot(const PlotOptions& options) {
  const bool into_file = options.output.has_extension();
  if (into_file && options.what.size() > 1) {
    throw InputError(options.output.string() + ": several charts go into a folder; name one with -o");
  }
  std::vector<RunReader> runs;
  for (const auto& path : options.paths) runs.emplace_back(path);
  std::vector<Plot> plots;
  for (const std::string& name : options.what) plots.push_back(plot_named(name, options, runs));
  std::optional<OutputFolder> folder;
  if (!into_file) folder.emplace(options.output);
  for (Plot& plot : plots) {
    const fs::path file = into_file ? options.output : options.output / (plot.name + ".png");
    check_writable(file);
    save_figure(file, std::move(plot.drawing), options.figure, plot.supersampling, plot.title);
  }
}

}  // namespace

void add_plot(Program& program) {
  auto options = std::make_shared<PlotOptions>();
  options->figure.size = "1600x1000";
  Verb verb = program.add_verb(plot_verb.name, plot_verb.description);
  verb.add("paths", options->paths, "Run folders").required();
  verb.add("--what", options->what, "Charts, by comma: " + joined(chart_names())).by_comma().required();
  verb.add("-o,--output", options->output, "x.png, x.svg or x.pdf; a folder for several charts").required().of_call();
  verb.add_view_options();
  add_figure_options(verb, options->figure);
  verb.add("--title", options->title, "Title [the chart's]; - for none");
  verb.set_action([options] { plot(*options); });
}

}  // namespace packstone::cli
