// Films of a run, and its frames as pictures.
#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/render_call.hpp"
#include "cli/selection.hpp"
#include "core/error.hpp"
#include "viz/movie.hpp"
#include "viz/png.hpp"
#include "viz/workers.hpp"

namespace packstone::cli {

namespace {

/// The colour scale of a film spans all of its frames.
void fix_range(viz::PictureOptions& picture, const RunReader& run, const std::vector<std::size_t>& frames) {
  if (picture.range || viz::colours_categories(picture.color)) return;
  for (const std::size_t index : frames) {
    const auto range = viz::value_range(run.snapshot(index, read_for(picture)), picture.color);
    if (!range) continue;  // no particles yet
    picture.range = picture.range ? std::pair{std::min(picture.range->first, range->first),
                                              std::max(picture.range->second, range->second)}
                                  : *range;
  }
}

/// Frames that every worker draws for itself; paint(painter, frame, result) makes the result of one.
template <class Paint>
viz::WorkInUnits frames_in_units(const viz::PictureOptions& picture, std::size_t frames, std::size_t result_bytes,
                                 const Paint& paint, std::function<void(std::size_t, const std::uint8_t*)> take) {
  const auto prepare = [&picture, paint] {
    const auto painter = std::make_shared<viz::ParticlePainter>(picture);
    return [painter, paint](std::size_t k, std::uint8_t* result) { paint(*painter, k, result); };
  };
  return {
      .count = frames, .unit_name = "frame", .result_bytes = result_bytes, .prepare = prepare, .take = std::move(take)};
}

}  // namespace

void render_film(const RenderCall& call, const RunReader& run) {
  const std::vector<std::size_t> frames = frame_range(run, call.frames.empty() ? ":" : call.frames);
  viz::PictureOptions picture = picture_options(call, run);
  viz::check_picture(picture);
  fix_range(picture, run, frames);
  Progress progress("frames", call.quiet);
  const auto note = [&](std::size_t done) {
    if (interrupted()) throw Interrupted(fmt::format("stopped after {} of {} frames", done, frames.size()));
    progress.update(static_cast<std::int64_t>(done), static_cast<std::int64_t>(frames.size()));
  };
  if (!call.output.has_extension()) {
    std::error_code error;
    std::filesystem::create_directories(call.output, error);
    if (error) throw InputError(call.output.string() + ": cannot be made: " + error.message());
    const auto paint = [&](viz::ParticlePainter& painter, std::size_t k, std::uint8_t*) {
      const Snapshot snapshot = run.snapshot(frames[k], read_for(picture));
      const auto file = call.output / fmt::format("frame_{:06}.png", frames[k]);
      viz::write_png(file, painter.paint(snapshot), provenance(run, snapshot));
    };
    const auto take = [&](std::size_t k, const std::uint8_t*) { note(k + 1); };
    viz::do_units(frames_in_units(picture, frames.size(), 0, paint, take), worker_count(call));
    return;
  }
  viz::MovieWriter movie(call.output, picture.width, picture.height, viz::MovieOptions{call.rate});
  viz::Image image{picture.width, picture.height, {}};
  const std::size_t bytes = viz::PixelWindow{0, 0, picture.width, picture.height}.pixels() * 3;
  const auto paint = [&](viz::ParticlePainter& painter, std::size_t k, std::uint8_t* result) {
    const viz::Image frame = painter.paint(run.snapshot(frames[k], read_for(picture)));
    std::copy(frame.rgb.begin(), frame.rgb.end(), result);
  };
  const auto take = [&](std::size_t k, const std::uint8_t* result) {
    image.rgb.assign(result, result + bytes);
    movie.add(image);
    note(k + 1);
  };
  viz::do_units(frames_in_units(picture, frames.size(), bytes, paint, take), worker_count(call));
  movie.finish();
}

}  // namespace packstone::cli
