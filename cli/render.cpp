// packstone render: pictures and films of a packing in space.

#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/progress.hpp"
#include "cli/selection.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "viz/movie.hpp"
#include "viz/particle_scene.hpp"
#include "viz/png.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

struct RenderOptions {
  fs::path path;
  fs::path output;
  PictureCall picture;
  std::string camera = "iso";
  std::string at = "last";
  std::string frames;
  int rate = 25;
  bool quiet = false;
};

viz::PictureOptions picture_options(const RenderOptions& options, const RunReader& run) {
  viz::PictureOptions picture;
  std::tie(picture.width, picture.height) = picture_size(options.picture.size);
  picture.supersampling = options.picture.supersampling;
  picture.color = options.picture.color;
  picture.range = colour_range(options.picture.range);
  picture.view = viz::view_named(options.camera);
  picture.title = picture_title(run, options.picture.title);
  return picture;
}

/// The colour scale of a film spans all of its frames.
void fix_range(viz::PictureOptions& picture, const RunReader& run, const std::vector<std::size_t>& frames) {
  if (picture.range) return;
  for (const std::size_t index : frames) {
    ReadOptions without_contacts;
    without_contacts.contacts = false;
    const auto range = viz::value_range(run.snapshot(index, without_contacts), picture.color);
    if (!range) continue;
    picture.range = picture.range ? std::pair{std::min(picture.range->first, range->first),
                                              std::max(picture.range->second, range->second)}
                                  : *range;
  }
}

void render_sequence(const RenderOptions& options, const RunReader& run, const std::vector<std::size_t>& frames) {
  viz::PictureOptions picture = picture_options(options, run);
  fix_range(picture, run, frames);
  const bool film = options.output.has_extension();
  std::unique_ptr<viz::MovieWriter> movie;
  if (film) {
    movie = std::make_unique<viz::MovieWriter>(options.output, picture.width, picture.height,
                                               viz::MovieOptions{options.rate});
  } else {
    std::error_code error;
    fs::create_directories(options.output, error);
    if (error) throw InputError(options.output.string() + ": cannot be made: " + error.message());
  }
  viz::ParticlePainter painter(picture);
  Progress progress("frames", options.quiet);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (interrupted()) throw Interrupted(fmt::format("stopped after {} of {} frames", k, frames.size()));
    ReadOptions without_contacts;
    without_contacts.contacts = false;
    const Snapshot snapshot = run.snapshot(frames[k], without_contacts);
    const viz::Image image = painter.paint(snapshot);
    if (movie) {
      movie->add(image);
    } else {
      viz::write_png(options.output / fmt::format("frame_{:06}.png", frames[k]), image, provenance(run, snapshot));
    }
    progress.update(static_cast<std::int64_t>(k + 1), static_cast<std::int64_t>(frames.size()));
  }
  if (movie) movie->finish();
}

void render(const RenderOptions& options) {
  const RunReader run(options.path);
  const std::string extension = options.output.extension().string();
  catch_interrupts();
  if (extension == ".png") {
    if (!options.frames.empty()) {
      throw InputError("--frames makes a film or a folder of pictures; name x.mp4, x.gif or a folder with -o");
    }
    const Snapshot snapshot = run.snapshot(run.index_at(options.at));
    const auto picture = picture_options(options, run);
    viz::write_png(options.output, viz::draw_particles(snapshot, picture), provenance(run, snapshot));
  } else if (extension == ".mp4" || extension == ".gif" || extension.empty()) {
    render_sequence(options, run, frame_range(run, options.frames.empty() ? ":" : options.frames));
  } else {
    throw InputError(fmt::format("{}: a picture is written as .png, a film as .mp4 or .gif, frames into a folder",
                                 options.output.string()));
  }
}

}  // namespace

void add_render(Program& program) {
  auto options = std::make_shared<RenderOptions>();
  Verb verb = program.add_verb(render_verb.name, render_verb.description);
  verb.add("path", options->path, "Run folder, snapshot, or a file of another program").required();
  verb.add("-o,--output", options->output, "x.png, x.mp4, x.gif, or a folder for frames").required();
  verb.add("--camera", options->camera, "iso, front, back, left, right, top or bottom").shows_default();
  verb.add("--at", options->at, "Of a picture: last, first, a number, or t=SECONDS").shows_default();
  verb.add("--frames", options->frames, "Of a film: FIRST:LAST:STRIDE [all]");
  verb.add("--rate", options->rate, "Frames a second of a film").between(1, 120).shows_default();
  add_picture_options(verb, options->picture);
  verb.add_flag("--quiet", options->quiet, "No progress");
  verb.set_action([options] { render(*options); });
}

}  // namespace packstone::cli
