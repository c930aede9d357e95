// What a camera's rays cross of a cut-away: where a body that is cut through shows its face.
#pragma once

#include <vector>

#include "viz/camera.hpp"
#include "viz/cut_away.hpp"

namespace packstone::viz {

/// The part of a ray in which all is cut away, as distances along the camera's axis from the viewer; none where from is
/// not below to.
struct CutSpan {
  double from;
  double to;
  Vec3 normal;  ///< of the face where it ends, towards what is cut away, in the camera's axes: right, down, away
};

class CutRays {
 public:
  /// A cut in space whose lengths are those of the camera's space after (place - origin) * scale.
  CutRays(const CutAway& cut, const Vec3& origin, double scale, const Camera& camera);

  /// Along the ray of a pixel's middle, the same whatever window is drawn.
  CutSpan span(int row, int column) const;

 private:
  CutAway cut_;  // in the camera's space
  Camera camera_;
};

}  // namespace packstone::viz
