// Films of a run, and its frames as pictures.
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "cli/film.hpp"
#include "cli/render_call.hpp"
#include "cli/selection.hpp"

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
    if (range) picture.range = viz::united(picture.range, *range);
    if (!overlay.needs_common_scale()) continue;
    const viz::Overlay shown = overlay.of(snapshot, index);
    if (forces)
      picture.look.thickest_force = std::max(picture.look.thickest_force, shown.links.quantile(viz::link_quantile));
    if (lengths)
      picture.look.longest_arrow = std::max(picture.look.longest_arrow, shown.arrows.quantile(viz::arrow_quantile));
  }
}

}  // namespace

void render_film(const RenderCall& call, const RunReader& run, viz::Ranks& ranks) {
  const std::vector<std::size_t> frames = frame_range(run, call.frames.empty() ? ":" : call.frames);
  viz::PictureOptions picture = picture_options(call, run);
  viz::check_picture(picture);
  const OverlayMaker overlay(call.overlay, run, frames);
  fix_scales(picture, run, frames, overlay);
  const Provenance provenance(run, frames.front(), call.recipe);
  const auto prepare = [&] {
    const auto painter = std::make_shared<viz::ParticlePainter>(picture);
    return [&, painter](std::size_t frame) {
      const Snapshot snapshot = run.snapshot(frames[frame], read_for(picture, overlay));
      return painter->paint(snapshot, overlay.of(snapshot, frames[frame]));
    };
  };
  make_film({.output = call.output,
             .width = picture.width,
             .height = picture.height,
             .rate = call.rate,
             .quiet = call.quiet,
             .workers = worker_count(call.workers),
             .frames = frames.size(),
             .subject = run.snapshot_files().at(frames.back()).filename().string(),
             .prepare = prepare,
             .file_name = [&](std::size_t frame) { return fmt::format("frame_{:06}.png", frames[frame]); },
             .text = [&](std::size_t frame) { return provenance.at(frames[frame]); }},
            ranks);
}

}  // namespace packstone::cli
