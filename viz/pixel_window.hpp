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
  /// The same part of the picture in pixels a factor smaller.
  PixelWindow finer(int factor) const { return {left * factor, top * factor, width * factor, height * factor}; }

  bool operator==(const PixelWindow&) const = default;
};

/// Visits the tiles of a window, row by row from the top left: at most side wide and high, none across the lines of a
/// grid of squares over the whole picture.
template <class Visit>
void for_each_aligned_tile(const PixelWindow& window, int square, int side, Visit&& visit) {
  const auto end = [&](int from, int last) { return std::min({last, from + side, (from / square + 1) * square}); };
  for (int top = window.top, bottom = 0; top < window.bottom(); top = bottom) {
    bottom = end(top, window.bottom());
    for (int left = window.left, right = 0; left < window.right(); left = right) {
      right = end(left, window.right());
      visit(PixelWindow{left, top, right - left, bottom - top});
    }
  }
}

}  // namespace packstone::viz
