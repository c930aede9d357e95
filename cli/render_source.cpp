#include "cli/render_source.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/selection.hpp"
#include "core/error.hpp"

namespace packstone::cli {

RenderSource::RenderSource(const RenderCall& call, const std::string& at, const std::string& frames)
    : runs_(call.paths.begin(), call.paths.end()), titles_(panel_titles(call.titles, runs_)) {
  for (const RunReader& run : runs_) {
    snapshots_.push_back(frames.empty() ? std::vector{run.index_at(at)} : frame_range(run, frames));
    if (snapshots_.back().size() != snapshots_.front().size()) {
      throw InputError(fmt::format("--frames {}: {} has {} such snapshots, {} has {}", frames,
                                   runs_.front().path().string(), snapshots_.front().size(), run.path().string(),
                                   snapshots_.back().size()));
    }
    overlays_.emplace_back(call.overlay, run, snapshots_.back());
  }
}

std::string RenderSource::subject() const {
  return runs_.front().snapshot_files().at(snapshots_.front().back()).filename().string();
}

OpenSnapshot RenderSource::open(std::size_t run, std::size_t index) const {
  const OverlayMaker& overlay = overlays_[run];
  if (!overlay.draws()) return runs_[run].open(index);
  return OpenSnapshot(runs_[run].snapshot(index, {.region = {}, .contacts = overlay.needs_contacts()}));
}

void RenderSource::fix_scales(viz::PictureOptions& picture) const {
  const bool colours = !picture.range && !viz::colours_categories(picture.color);
  const bool forces = picture.look.thickest_force == 0, lengths = picture.look.longest_arrow == 0;
  const bool sizes = overlays_.front().needs_common_scale();
  if (frames() * runs_.size() == 1 || (!colours && !sizes)) return;
  for (std::size_t frame = 0; frame < frames(); ++frame) {
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      const std::size_t index = snapshots_[run][frame];
      const OpenSnapshot snapshot = open(run, index);
      const auto range = colours ? viz::value_range(snapshot.view(), picture.color) : std::nullopt;
      if (range) picture.range = viz::united(picture.range, *range);
      if (!sizes) continue;
      const viz::Overlay shown = overlays_[run].of(*snapshot.view().snapshot, index);
      viz::OverlayLook& look = picture.look;
      if (forces) look.thickest_force = std::max(look.thickest_force, shown.links.quantile(viz::link_quantile));
      if (lengths) look.longest_arrow = std::max(look.longest_arrow, shown.arrows.quantile(viz::arrow_quantile));
    }
  }
  const bool one_value = picture.range && !(picture.range->first < picture.range->second);
  if (one_value) picture.range.reset();  // every picture widens it in the same way
}

RenderSource::Shown RenderSource::read(std::size_t frame) const {
  Shown shown;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    const std::size_t index = snapshots_[run][frame];
    const ParticleView view = shown.snapshots.emplace_back(open(run, index)).view();
    shown.contents.push_back({view, overlays_[run].of(*view.snapshot, index)});
  }
  return shown;
}

}  // namespace packstone::cli
