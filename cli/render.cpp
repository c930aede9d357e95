// packstone render: pictures and films of a packing in space.

#include <memory>

#include <fmt/format.h>

#include "cli/failing_view.hpp"
#include "cli/film.hpp"
#include "cli/interrupt.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/render_call.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "viz/offscreen.hpp"

namespace packstone::cli {

viz::PictureOptions picture_options(const RenderCall& call, const std::vector<RunReader>& runs) {
  viz::PictureOptions picture;
  std::tie(picture.width, picture.height) = picture_size(call.picture.size);
  picture.supersampling = call.picture.supersampling;
  if (!call.picture.color.empty()) picture.color = call.picture.color;
  picture.range = colour_range(call.picture.range);
  picture.view = viz::viewpoint_from_text(call.camera);
  picture.view.zoom = call.zoom;
  if (!call.focus.empty()) {
    picture.view.focus = parse_vector(call.focus, unit::metre);
    if (!picture.view.focus) {
      throw InputError(fmt::format("--focus {}: expected X,Y,Z, such as 0.1,0.1,0.3 or \"100 mm,0,0.3\"", call.focus));
    }
  }
  picture.title = figure_title(runs, call.picture.title);
  if (runs.size() > 1 && !picture.title.empty()) {
    throw InputError(fmt::format("--title {}: of several panels each has its title, --titles", picture.title));
  }
  picture.font_scale = call.font_scale;
  picture.ground = ground_named(call.picture.ground);
  picture.occlusion = call.occlusion;
  picture.cut = viz::cut_from_text(call.cut);
  picture.cut_through = call.cut_through;
  if (call.cut_through && picture.cut.empty()) throw InputError("--cut-through: name the planes with --cut");
  picture.parts = call.parts;
  take_overlay(call.overlay, picture);
  return picture;
}

namespace {

void render(RenderCall call, viz::Ranks& ranks) {
  show_failure(call);
  const std::string extension = call.output.extension().string();
  check_frame_options(call.output, call.kept_frames, Film{}.frame_format);
  catch_interrupts();
  viz::use_backend(viz::backend_named(call.backend));
  if (extension == ".png") {
    if (!call.frames.empty()) {
      throw InputError("--frames makes a film or a folder of pictures; name x.mp4, x.gif or a folder with -o");
    }
    render_picture(call, ranks);
  } else if (extension == ".mp4" || extension == ".gif" || extension.empty()) {
    if (!call.tiles.empty())
      throw InputError("--tiles divides one picture; films and folders are shared out by frames");
    render_film(call, ranks);
  } else {
    throw InputError(fmt::format("{}: a picture is written as .png, a film as .mp4 or .gif, frames into a folder",
                                 call.output.string()));
  }
}

}  // namespace

void add_render(Program& program) {
  constexpr int most_workers = 1024, most_parts = 1000, most_columns = 100;
  constexpr double smallest_zoom = 0.01, largest_zoom = 1e4;
  auto call = std::make_shared<RenderCall>();
  Verb verb = program.add_verb(render_verb.name, render_verb.description);
  verb.add("paths", call->paths, "Run folders, snapshots, or files of other programs; a panel for each").required();
  verb.add("-o,--output", call->output, "x.png, x.mp4, x.gif, or a folder for frames").required().of_call();
  verb.add_view_options();
  verb.add("--camera", call->camera, "iso, front, back, left, right, top, bottom, or AZIMUTH,ELEVATION in degrees")
      .shows_default();
  verb.add("--zoom", call->zoom, "Enlarge around the focus").between(smallest_zoom, largest_zoom).shows_default();
  verb.add("--focus", call->focus,
           "Place in the middle of the picture: X,Y,Z with units or in m [the domain's middle]");
  const Option at = verb.add("--at", call->at, "Of a picture: last, first, a number, or t=SECONDS").shows_default();
  verb.add_flag("--failure", call->failure, "Of runs that were stopped: the state in which they were, offenders marked")
      .not_with(at);
  verb.add("--frames", call->frames, "Of a film: FIRST:LAST:STRIDE [all]");
  verb.add("--keep-frames", call->kept_frames, keep_frames_description).of_call();
  verb.add("--rate", call->rate, "Frames a second of a film").between(1, 120).shows_default();
  add_picture_options(verb, call->picture);
  verb.add("--titles", call->titles, "Of the panels, by comma [the runs']").by_comma();
  verb.add("--columns", call->columns, "Panels side by side [up to three]").between(1, most_columns);
  add_overlay_options(verb, call->overlay);
  verb.add("--cut", call->cut, "Leave out what has its middle where all of these hold: x>0.3 or \"x>300 mm,y<0.2\"");
  verb.add_flag("--cut-through", call->cut_through, "Cut particles at the planes of --cut, with flat faces there");
  verb.add("--occlusion", call->occlusion, "How dark hollows between particles are drawn, 0 to 1")
      .between(0.0, 1.0)
      .shows_default();
  verb.add("--workers", call->workers, "Processes that share frames or tiles [one a core]")
      .between(1, most_workers)
      .of_call();
  verb.add("--tiles", call->tiles, "COLUMNSxROWS of a picture, to share out [by its size]").of_call();
  verb.add("--parts", call->parts, "Draw the particles in so many parts, merged by depth")
      .between(1, most_parts)
      .shows_default()
      .of_call();
  verb.add("--font-scale", call->font_scale, "Size of letters and lines, over the usual")
      .between(0.1, 10.0)
      .shows_default();
  verb.add("--backend", call->backend, "Where OpenGL, for the walls, comes from: osmesa, egl or vtk")
      .shows_default()
      .of_call();
  verb.add_flag("--quiet", call->quiet, "No progress").of_call();
  verb.set_action([call, verb] {
    call->recipe = verb.recipe();
    viz::with_ranks([&](viz::Ranks& ranks) { render(*call, ranks); });
  });
}

}  // namespace packstone::cli
