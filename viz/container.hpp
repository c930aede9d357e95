// The domain's box and its boundaries, as thin rods, plates and shaded surfaces.
#pragma once

#include <memory>
#include <vector>

#include "core/snapshot.hpp"
#include "viz/camera.hpp"

class vtkRenderer;

namespace packstone::viz {

/// The part of a plane inside a box: its corners in order around the normal; empty when they do not meet.
std::vector<Vec3> plane_in_box(const Vec3& point, const Vec3& normal, const Vec3& min, const Vec3& max);

/// The container's actors in one renderer.
class Container {
 public:
  Container(vtkRenderer* renderer, Ground ground);
  ~Container();

  /// Periodic edges are dashed. A wall is a plate where the particles lie before it, an outline where it would hide
  /// them; so is each triangle of a one-sided surface, while a two-sided one is drawn as a whole. What of a surface
  /// lies outside the domain is drawn as well. Positions p of the snapshot lie at (p - centre) * scale; lines are
  /// line_width pixels wide.
  void update(const Snapshot& snapshot, const Vec3& centre, double scale, const Camera& camera, double line_width);
  void hide();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace packstone::viz
