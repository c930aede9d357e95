// Labels as pixels, drawn anew only where they change from frame to frame.
#pragma once

#include "viz/annotation.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/image.hpp"

namespace packstone::viz {

/// Keeps its last picture.
class LabelLayer {
 public:
  /// All of the annotation, at its full size.
  const Layer& paint(const Annotation& annotation, int supersampling);

 private:
  DrawingPainter still_painter_, changing_painter_;
  Annotation shown_;
  Layer still_, labels_;
};

}  // namespace packstone::viz
