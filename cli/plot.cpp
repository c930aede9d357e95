// packstone plot: charts of one or several runs.

#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/charts.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
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

/// The file itself for one chart; for several, a folder that gets NAME.png each.
fs::path chart_file(const PlotOptions& options, const std::string& name) {
  if (options.what.size() == 1 && options.output.has_extension()) return options.output;
  if (options.output.has_extension()) {
    throw InputError(options.output.string() + ": several charts go into a folder; name one with -o");
  }
  std::error_code error;
  fs::create_directories(options.output, error);
  if (error) throw InputError(options.output.string() + ": cannot be made: " + error.message());
  return options.output / (name + ".png");
}

void plot(const PlotOptions& options) {
  std::vector<RunReader> runs;
  for (const auto& path : options.paths) runs.emplace_back(path);
  for (const std::string& name : options.what) {
    viz::Chart chart = make_chart(name, runs);
    take_size(options.figure, chart.options);
    if (!options.title.empty()) chart.options.title = options.title == "-" ? "" : options.title;
    save_figure(chart_file(options, name), viz::chart_drawing(chart), options.figure, chart.options.supersampling,
                chart.options.title);
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
