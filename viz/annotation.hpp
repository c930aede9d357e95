// Where the box, the legend and the labels of a view in space go, and their drawing.
#pragma once

#include <vector>

#include "viz/camera.hpp"
#include "viz/colouring.hpp"
#include "viz/drawing.hpp"
#include "viz/particle_scene.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::viz {

/// The domain of a snapshot brought to about unit size around the origin: q = (p - centre) * scale. The graphics work
/// with single precision, so lengths in micrometres would be lost otherwise.
struct UnitSpace {
  Vec3 centre;   ///< [m]
  double scale;  ///< [1/m]
  Vec3 min;      ///< of the domain, in unit space
  Vec3 max;

  explicit UnitSpace(const Domain& domain);
};

/// The camera, with room left for the labels, and where the column of legend, time and scale begins.
struct Layout {
  double font;
  Camera camera;
  Box column;
  std::optional<PixelWindow> frame;  ///< outside of which no particles are drawn, where the camera looks closer
};

/// What the colours of a picture mean, from the top of its column; none where the legend is not wanted.
using ColourKeys = std::vector<ColourKey>;

/// Room to the right of what is seen, for the column of legend, time and scale, else for the length of an edge [px].
double room_beside(const PictureOptions& options, const UnitSpace& space, const ColourKeys& keys);

Layout lay_out(const PictureOptions& options, const UnitSpace& space, const ColourKeys& keys);

/// All that stands beside the particles, of the size of the picture.
struct Annotation {
  Drawing still;            ///< the same for all frames of a film
  Drawing changing;         ///< the time
  PixelWindow changing_in;  ///< where that is drawn, and nothing else
};
Annotation annotate(const PictureOptions& options, const UnitSpace& space, const Layout& layout, const ColourKeys& keys,
                    double time);

}  // namespace packstone::viz
