// A plane cut through a packing, true to scale: the discs in which the plane cuts the spheres, the lines in which it
// cuts the boundaries.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/snapshot.hpp"
#include "viz/colouring.hpp"
#include "viz/drawing.hpp"
#include "viz/image.hpp"
#include "viz/style.hpp"

namespace packstone::viz {

/// The plane of all points whose coordinate along an axis (0 x, 1 y, 2 z) has a value [m].
struct SlicePlane {
  int axis = 2;
  double position = 0;
};

/// From "z=0.1" or "y = 290 mm". Throws InputError otherwise.
SlicePlane plane_from_text(const std::string& text);

/// The two axes in the plane: to the right and up in the picture.
struct PlaneAxes {
  int u;
  int v;
};
PlaneAxes axes_in_plane(int axis);

/// Where the plane cuts one sphere.
struct Disc {
  double u = 0;         ///< centre along the first axis in the plane [m]
  double v = 0;         ///< along the second [m]
  double radius = 0;    ///< sqrt(r^2 - h^2), h being the sphere's distance from the plane [m]
  std::size_t row = 0;  ///< of the particle in the snapshot
};

/// All discs that reach into the domain, the periodic images included: exactly one image of each disc has its centre in
/// the domain along the periodic axes, and the parts inside the domain add up to the area cut.
/// Throws InputError when the plane misses the domain.
std::vector<Disc> slice_discs(const Snapshot& snapshot, const SlicePlane& plane);

struct SliceOptions {
  int width = 1600;                 ///< [px]
  int height = 1200;                ///< [px]
  int supersampling = 3;            ///< of the PNG; 1 to 4 are sensible
  std::string color = "type";       ///< see colour_names()
  std::optional<ValueRange> range;  ///< of the colour scale, SI; the default is the whole snapshot's own
  std::string title;
  bool legend = true;
  bool time = true;
  double font_scale = 1;  ///< of the usual size for the picture
  double margin = usual_margin;
};

/// The cut in the domain's outline, with axes, scale bar and legend; for svg_text or save_drawing.
/// Throws InputError when the plane misses the domain or the snapshot lacks what to colour by.
Drawing slice_drawing(const Snapshot& snapshot, const SlicePlane& plane, const SliceOptions& options);

/// The same as pixels.
Image draw_slice(const Snapshot& snapshot, const SlicePlane& plane, const SliceOptions& options);

}  // namespace packstone::viz
