// The overlay of a picture as tubes, cones and spheres.
#pragma once

#include <vector>

#include "viz/annotation.hpp"
#include "viz/colouring.hpp"
#include "viz/cut_away.hpp"
#include "viz/frustum_cloud.hpp"
#include "viz/overlay.hpp"
#include "viz/particle_scene.hpp"

namespace packstone::viz {

/// Bodies in unit space.
struct OverlayBodies {
  std::vector<Frustum> frusta;
  // Round ends and bends of tubes.
  std::vector<Vec3> centres;
  std::vector<double> radii;
  std::vector<Colour> colours;
  /// What the colours of tubes and arrows mean.
  ColourKeys keys;

  /// colouring: of the snapshot's particles, whose colours their paths take.
  OverlayBodies(const Overlay& overlay, const Snapshot& snapshot, const UnitSpace& space, const Colouring& colouring,
                const PictureOptions& options);

 private:
  class Builder;
};

}  // namespace packstone::viz
