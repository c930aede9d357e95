// What packstone render draws among the particles.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "core/run_folder.hpp"
#include "viz/particle_scene.hpp"

namespace packstone::cli {

struct OverlayCall {
  std::string particles;  ///< all, shrunk, hidden; empty: as the rest asks for
  std::string arrows;     ///< a field of vectors
  bool contacts = false;
  bool chains = false;
  std::string trajectories;  ///< particles, see particles_chosen
  int tail = 20;             ///< snapshots
  viz::OverlayLook look;
};

void add_overlay_options(Verb& verb, OverlayCall& call);

/// Sets what the picture needs to know. Throws InputError.
void take_overlay(const OverlayCall& call, viz::PictureOptions& picture);

/// Makes the overlay of any snapshot of a run.
class OverlayMaker {
 public:
  /// Reads the paths that end in the frames, ascending snapshots. Throws InputError.
  OverlayMaker(const OverlayCall& call, const RunReader& run, const std::vector<std::size_t>& frames);

  /// Whether there is anything to draw among the particles.
  bool draws() const { return needs_contacts() || needs_fields() || !call_.trajectories.empty(); }
  bool needs_contacts() const { return call_.contacts || call_.chains; }
  bool needs_fields() const { return !call_.arrows.empty(); }
  /// Whether sizes depend on other frames than their own.
  bool needs_common_scale() const;

  viz::Overlay of(const Snapshot& snapshot, std::size_t index) const;

 private:
  void read_paths(const RunReader& run, const std::vector<std::size_t>& frames);

  OverlayCall call_;
  std::vector<std::int64_t> followed_;  ///< ids
  std::size_t first_read_ = 0;
  /// Of snapshot first_read_ + k, the place of each followed particle; not a number where it is not there.
  std::vector<std::vector<Vec3>> places_;
};

}  // namespace packstone::cli
