// Pictures in space of several packings side by side, to one scale of length and with one legend.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/particle_view.hpp"
#include "viz/overlay.hpp"
#include "viz/particle_scene.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::viz {

/// What a panel shows; the overlay may be empty.
struct PanelContent {
  ParticleView particles;
  Overlay overlay;
};

/// Draws as ParticlePainter does: one panel fills the picture and is the same byte for byte. Of more each has its title
/// after a letter; colours and sizes have the scales of the options, which should be given then.
class PanelPainter {
 public:
  /// titles: one a panel. columns: 0 for as many as there are up to three, then about as many as rows. Throws
  /// InputError as check_picture does, and where the panels have no room.
  PanelPainter(const PictureOptions& options, std::vector<std::string> titles, int columns);
  ~PanelPainter();

  /// What is to be seen, as many as there are titles; then any parts of the picture, byte for byte those of the whole.
  void show(const std::vector<PanelContent>& contents);
  Image part(const PixelWindow& window);
  Image paint(const std::vector<PanelContent>& contents);

 private:
  struct Panel;
  void lay_out(const std::vector<PanelContent>& contents, const Colouring& colouring);

  PictureOptions options_;
  std::vector<std::string> titles_;
  int columns_;
  std::vector<Panel> panels_;
  bool times_differ_ = false;
};

}  // namespace packstone::viz
