// The snapshots that packstone render shows: of each picture one of each run, with what is drawn among the particles.
#pragma once

#include <string>
#include <vector>

#include "cli/render_call.hpp"
#include "core/run_folder.hpp"
#include "viz/panel_painter.hpp"

namespace packstone::cli {

class RenderSource {
 public:
  /// at: where a picture's snapshot is, or frames: the snapshots of a film's, as in frame_range; the other is empty.
  /// Throws InputError.
  RenderSource(const RenderCall& call, const std::string& at, const std::string& frames);

  const std::vector<RunReader>& runs() const { return runs_; }
  /// Of the panels; empty names where there is one.
  const std::vector<std::string>& titles() const { return titles_; }
  std::size_t frames() const { return snapshots_.front().size(); }
  /// Number of the first run's snapshot in a frame.
  std::size_t snapshot_of(std::size_t frame) const { return snapshots_.front()[frame]; }
  /// As WorkInUnits::subject.
  std::string subject() const;

  /// Scales that are not given span all frames of all runs, where there is more than one.
  void fix_scales(viz::PictureOptions& picture) const;

  /// What a frame shows: particles where they lie, and where something is drawn among them in memory.
  struct Shown {
    std::vector<OpenSnapshot> snapshots;
    std::vector<viz::PanelContent> contents;  ///< refers to them
  };
  Shown read(std::size_t frame) const;

 private:
  OpenSnapshot open(std::size_t run, std::size_t index) const;

  std::vector<RunReader> runs_;
  std::vector<std::string> titles_;
  std::vector<std::vector<std::size_t>> snapshots_;  ///< of each run, frame by frame
  std::vector<OverlayMaker> overlays_;               ///< of each run
};

}  // namespace packstone::cli
