// Drawings for paper: millimetres, points and dots an inch.
#pragma once

#include "viz/drawing.hpp"

namespace packstone::viz {

/// How large a drawing stands on paper.
struct PrintSize {
  double width_mm = 85;  ///< a column of most journals
  double height_mm = 55;
  double font_pt = 8;  ///< of ticks and labels; titles are larger
  double dots_per_inch = 600;

  int width() const;    ///< [px]
  int height() const;   ///< [px]
  double font() const;  ///< [px]
};

/// No line thinner than what prints well, 0.5 pt, outlines of discs 0.25 pt, and the size on paper for the files. The
/// drawing has the print's width and height in pixels.
void prepare_for_print(Drawing& drawing, const PrintSize& print);

}  // namespace packstone::viz
