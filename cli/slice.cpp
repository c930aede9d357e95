// packstone slice: the discs in which a plane cuts a packing.

#include <filesystem>
#include <memory>

#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/verbs.hpp"
#include "core/run_folder.hpp"
#include "viz/slice_drawing.hpp"

namespace packstone::cli {

namespace {

struct SliceCall {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path output;
  std::string plane;
  std::string at = "last";
  int columns = 0;
  FigureCall figure;
  PictureCall picture;
  std::string recipe;  ///< Verb::recipe
};

/// What a panel is called among others: the run's title, else the file's name.
std::string panel_title(const RunReader& run) {
  const std::string title = run.is_folder() ? run.record().title : "";
  return title.empty() ? run.path().filename().string() : title;
}

viz::SliceOptions slice_options(const SliceCall& call, const RunReader& run) {
  viz::SliceOptions options;
  options.supersampling = call.picture.supersampling;
  take_size(call.figure, options);
  options.color = call.picture.color;
  options.range = colour_range(call.picture.range);
  const bool panels = call.paths.size() > 1 && call.picture.title.empty();  // each has its own
  options.title = panels ? "" : picture_title(run, call.picture.title);
  options.columns = call.columns;
  return options;
}

void slice(const SliceCall& call) {
  const viz::SlicePlane plane = viz::plane_from_text(call.plane);
  std::vector<RunReader> runs(call.paths.begin(), call.paths.end());
  const viz::SliceOptions options = slice_options(call, runs.front());
  std::vector<Snapshot> snapshots;
  for (const RunReader& run : runs) {
    snapshots.push_back(
        run.snapshot(run.index_at(call.at),
                     {.region = {}, .contacts = false, .fields = viz::colour_needs_fields(call.picture.color)}));
  }
  std::vector<viz::SlicePanel> panels;
  for (std::size_t k = 0; k < runs.size(); ++k) panels.push_back({snapshots[k], plane, panel_title(runs[k])});
  save_figure(call.output, viz::slice_drawing(panels, options), call.figure, options.supersampling, options.title,
              provenance(runs.front(), snapshots.front(), call.recipe));
}

}  // namespace

void add_slice(Program& program) {
  constexpr int most_columns = 100;
  auto call = std::make_shared<SliceCall>();
  call->figure.size = "1600x1200";
  Verb verb = program.add_verb(slice_verb.name, slice_verb.description);
  verb.add("paths", call->paths, "Run folders, snapshots, or files of other programs; a panel for each").required();
  verb.add("--plane", call->plane, "z=0.1, \"y=290 mm\", or any: \"through 0.1,0.1,0.2 normal 1,1,0\"").required();
  verb.add("-o,--output", call->output, "x.png, x.svg or x.pdf").required().of_call();
  verb.add_view_options();
  verb.add("--at", call->at, "last, first, a number, or t=SECONDS").shows_default();
  verb.add("--columns", call->columns, "Panels side by side [up to three]").between(1, most_columns);
  add_figure_options(verb, call->figure);
  add_look_options(verb, call->picture);
  verb.set_action([call, verb] {
    call->recipe = verb.recipe();
    slice(*call);
  });
}

}  // namespace packstone::cli
