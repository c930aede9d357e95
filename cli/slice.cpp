// packstone slice: the discs in which a plane cuts a packing.

#include "viz/slice.hpp"

#include <filesystem>
#include <memory>

#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/verbs.hpp"
#include "core/run_folder.hpp"

namespace packstone::cli {

namespace {

struct SliceCall {
  std::filesystem::path path;
  std::filesystem::path output;
  std::string plane;
  std::string at = "last";
  FigureCall figure;
  PictureCall picture;
  std::string recipe;  ///< Verb::recipe
};

void slice(const SliceCall& call) {
  const RunReader run(call.path);
  const Snapshot snapshot = run.snapshot(run.index_at(call.at));
  viz::SliceOptions options;
  options.supersampling = call.picture.supersampling;
  take_size(call.figure, options);
  options.color = call.picture.color;
  options.range = colour_range(call.picture.range);
  options.title = picture_title(run, call.picture.title);
  save_figure(call.output, viz::slice_drawing(snapshot, viz::plane_from_text(call.plane), options), call.figure,
              options.supersampling, options.title, provenance(run, snapshot, call.recipe));
}

}  // namespace

void add_slice(Program& program) {
  auto call = std::make_shared<SliceCall>();
  call->figure.size = "1600x1200";
  Verb verb = program.add_verb(slice_verb.name, slice_verb.description);
  verb.add("path", call->path, "Run folder, snapshot, or a file of another program").required();
  verb.add("--plane", call->plane, "AXIS=POSITION, such as z=0.1 or \"y=290 mm\"").required();
  verb.add("-o,--output", call->output, "x.png, x.svg or x.pdf").required().of_call();
  verb.add_view_options();
  verb.add("--at", call->at, "last, first, a number, or t=SECONDS").shows_default();
  add_figure_options(verb, call->figure);
  add_look_options(verb, call->picture);
  verb.set_action([call, verb] {
    call->recipe = verb.recipe();
    slice(*call);
  });
}

}  // namespace packstone::cli
