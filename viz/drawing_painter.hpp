// A drawing as pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viz/drawing.hpp"
#include "viz/image.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::viz {

/// More pixels a side would take more than a gigabyte.
inline constexpr int max_drawing_side = 16384;

/// Turns drawings into pixels; keeps its memory between them.
class DrawingPainter {
 public:
  /// Transparent where nothing is drawn. Every pixel is the mean of supersampling x supersampling ones, each of which
  /// is as full as it is covered. Throws InputError when the size times supersampling exceeds max_drawing_side.
  Layer paint(const Drawing& drawing, int supersampling);
  /// A part of it, byte for byte that of the whole.
  Layer paint(const Drawing& drawing, const PixelWindow& window, int supersampling);

 private:
  std::vector<std::uint8_t> pixels_;  ///< of the last drawing, before averaging
};

/// One drawing on its ground.
Image draw_image(const Drawing& drawing, int supersampling);

}  // namespace packstone::viz
