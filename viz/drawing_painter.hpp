// A drawing as pixels.
#pragma once

#include <memory>

#include "viz/drawing.hpp"
#include "viz/image.hpp"

namespace packstone::viz {

/// Turns drawings into pixels; keeps its window between them.
class DrawingPainter {
 public:
  DrawingPainter();
  ~DrawingPainter();

  /// Transparent where nothing is drawn. Every pixel is the mean of supersampling x supersampling ones.
  /// Throws InputError when the size times supersampling is too large (offscreen.hpp).
  Layer paint(const Drawing& drawing, int supersampling);

 private:
  struct Stage;
  std::unique_ptr<Stage> stage_;
};

/// One drawing on white paper.
Image draw_image(const Drawing& drawing, int supersampling);

}  // namespace packstone::viz
