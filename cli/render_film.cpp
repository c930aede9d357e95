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

/// The scales of a film span all of its frames.
void fix_scales(viz::PictureOptions& picture, const RunReader& run, const std::vector<std::size_t>& frames,
                const OverlayMaker& overlay) {
  const bool colours = !picture.range && !viz::colours_categories(picture.color);
  const bool forces = picture.look.thickest_force == 0, lengths = picture.look.longest_arrow == 0;
  if (!colours && !overlay.needs_common_scale()) return;
  for (const std::size_t index : frames) {
    const Snapshot snapshot = run.snapshot(index, read_for(picture, overlay));
    const auto range = colours ? viz::value_range(snapshot, picture.color) : std::nullopt;
    if (range) {
      picture.range = picture.range ? std::pair{std::min(picture.range->first, range->first),
                                                std::max(picture.range->second, range->second)}
                                    : *range;
    }
    if (!overlay.needs_common_scale()) continue;
    const viz::Overlay shown = overlay.of(snapshot, index);
    if (forces)
      picture.look.thickest_force = std::max(picture.look.thickest_force, shown.links.quantile(viz::link_quantile));
    if (lengths)
      picture.look.longest_arrow = std::max(picture.look.longest_arrow, shown.arrows.quantile(viz::arrow_quantile));
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
  const OverlayMaker overlay(call.overlay, run, frames);
  fix_scales(picture, run, frames, overlay);
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
      const Snapshot snapshot = run.snapshot(frames[k], read_for(picture, overlay));
      const auto file = call.output / fmt::format("frame_{:06}.png", frames[k]);
      viz::write_png(file, painter.paint(snapshot, overlay.of(snapshot, frames[k])),
                     provenance(run, snapshot, call.recipe));
    };
    const auto take = [&](std::size_t k, const std::uint8_t*) { note(k + 1); };
    viz::do_units(frames_in_units(picture, frames.size(), 0, paint, take), worker_count(call));
    return;
  }
  viz::MovieWriter movie(call.output, picture.width, picture.height, viz::MovieOptions{call.rate});
  viz::Image image{picture.width, picture.height, {}};
  const std::size_t bytes = viz::PixelWindow{0, 0, picture.width, picture.height}.pixels() * 3;
  const auto paint = [&](viz::ParticlePainter& painter, std::size_t k, std::uint8_t* result) {
    const Snapshot snapshot = run.snapshot(frames[k], read_for(picture, overlay));
    const viz::Image frame = painter.paint(snapshot, overlay.of(snapshot, frames[k]));
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
