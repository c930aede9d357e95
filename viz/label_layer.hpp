// Labels as pixels, drawn anew only where they change from frame to frame.
#pragma once

#include "viz/annotation.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/image.hpp"

namespace packstone::viz {

/// Keeps its last picture where that is not large.
class LabelLayer {
 public:
  /// What the next parts are of.
  void show(Annotation annotation, int supersampling);

  Layer part(const PixelWindow& window);

 private:
  bool kept() const;

  DrawingPainter painter_;
  Annotation shown_;
  int supersampling_ = 0;
  Layer whole_;
};

}  // namespace packstone::viz
