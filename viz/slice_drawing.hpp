// Slices as figures: one, or panels of several side by side, true to one scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/particle_view.hpp"
#include "viz/colouring.hpp"
#include "viz/drawing.hpp"
#include "viz/image.hpp"
#include "viz/slice.hpp"
#include "viz/style.hpp"

namespace packstone::viz {

struct SliceOptions {
  int width = 1600;                 ///< [px]
  int height = 1200;                ///< [px]
  int supersampling = 3;            ///< of the PNG; 1 to 4 are sensible
  std::string color = "type";       ///< see colour_names()
  std::optional<ValueRange> range;  ///< of the colour scale, SI; the default is that of all snapshots shown
  std::string title;
  bool legend = true;
  bool time = true;
  double font_scale = 1;  ///< of the usual size for the picture
  double margin = usual_margin;
  int columns = 0;  ///< of panels; 0: as many as there are up to three, then about as many as rows
};

/// One slice of a figure.
struct SlicePanel {
  ParticleView particles;
  SlicePlane plane;
  std::string title;  ///< over it, after "(a) "; without panels beside it none is drawn
};

/// The cuts in the domains' outlines, with axes, and one scale bar and legend; for svg_text or save_drawing. Throws
/// InputError when a plane misses its domain or a snapshot lacks what to colour by.
Drawing slice_drawing(const std::vector<SlicePanel>& panels, const SliceOptions& options);
Drawing slice_drawing(const ParticleView& particles, const SlicePlane& plane, const SliceOptions& options);

/// The same as pixels.
Image draw_slice(const ParticleView& particles, const SlicePlane& plane, const SliceOptions& options);

}  // namespace packstone::viz
