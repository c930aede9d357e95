// A rectangle of a picture's pixels.
#pragma once

#include <algorithm>
#include <cstddef>

namespace packstone::viz {

/// Columns count from the picture's left, rows from its top.
struct PixelWindow {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;

  int right() const { return left + width; }
  int bottom() const { return top + height; }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  bool empty() const { return width <= 0 || height <= 0; }
  PixelWindow common(const PixelWindow& other) const {
    const int l = std::max(left, other.left), t = std::max(top, other.top);
    return {l, t, std::min(right(), other.right()) - l, std::min(bottom(), other.bottom()) - t};
  }
  /// With a margin all around, which may reach out of the picture.
  PixelWindow wider(int margin) const { return {left - margin, top - margin, width + 2 * margin, height + 2 * margin}; }
  /// The same part of the picture in pixels a factor smaller.
  PixelWindow finer(int factor) const { return {left * factor, top * factor, width * factor, height * factor}; }

  bool operator==(const PixelWindow&) const = default;
};

/// Visits the parts of a window that a grid of squares over the whole picture divides it into, row by row.
template <class Visit>
void for_each_square(const PixelWindow& window, int side, Visit&& visit) {
  const auto line = [&](int place) { return (place / side + 1) * side; };  // of the grid, next after it
  for (int top = window.top; top < window.bottom(); top = line(top)) {
    for (int left = window.left; left < window.right(); left = line(left)) {
      visit(window.common({left, top, line(left) - left, line(top) - top}));
    }
  }
}

}  // namespace packstone::viz
