// Where in the picture a body is, and how far: what decides whether it needs to be drawn.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "viz/camera.hpp"
#include "viz/pixel_window.hpp"
#include "viz/style.hpp"

namespace packstone::viz {

/// Pixels that something surely stays within, and how near it comes.
struct Outline {
  int left = 0, top = 0, after_right = 0, below = 0;
  float nearest = 0;  ///< distance along the camera's axis from the viewer that no point of it goes below

  bool empty() const { return left >= after_right || top >= below; }
};

/// The part of an outline in a window.
Outline clipped(Outline outline, const PixelWindow& window);

/// Of all that lies in an axis-aligned box.
Outline outline_of_box(const Vec3& low, const Vec3& high, const Camera& camera);

/// The first and last pixels whose middles a picture may cover, not yet whole numbers' type.
struct PixelReach {
  double left, right, top, bottom;
};

/// Of an outline whose last pixels are those of the reach. distance: that no point goes below.
Outline outline_of(const PixelReach& reach, double distance);

/// Of a sphere seen from the eye at (x, y, z). Its picture ends, along either side, at the tangents from the viewer:
/// with its centre so far across and along the line of sight these have the slopes (across along -+ r sqrt(across^2 +
/// along^2 - r^2)) / (along^2 - r^2). middle: Camera::centre() less half a pixel.
template <bool parallel>
inline PixelReach reach_of_sphere(double x, double y, double z, double r, double focal, Point middle) {
  constexpr double edge_safety = 0.01;  // [px] for the rounding of single precision
  const double square = parallel ? 1 : z * z - r * r, along = parallel ? 1 : z;
  const double reach_x = parallel ? r : r * std::sqrt(x * x + square);
  const double reach_y = parallel ? r : r * std::sqrt(y * y + square);
  const double scale = focal / square;
  return {std::ceil(middle.x + (x * along - reach_x) * scale - edge_safety),
          std::floor(middle.x + (x * along + reach_x) * scale + edge_safety),
          std::ceil(middle.y + (y * along - reach_y) * scale - edge_safety),
          std::floor(middle.y + (y * along + reach_y) * scale + edge_safety)};
}

/// Bodies in rows that stand near each other, which can be left out as a whole.
struct Packet {
  std::size_t first, last;  ///< rows, without the last
  Outline outline;
};
inline constexpr std::size_t rows_a_packet = 64;

/// The nearest first.
void sort_by_distance(std::vector<Packet>& packets);

/// A body that may be seen.
struct Candidate {
  Outline outline;
  std::size_t row;
};

/// Of the bodies of one packet, in the order of their rows, those that reach into a window, with the part of their
/// outlines in it, the nearest first.
void keep_visible(std::vector<Candidate>& candidates, const PixelWindow& window);

/// Red in the lowest byte, then green, blue.
inline std::uint32_t packed(Colour c) {
  return static_cast<std::uint32_t>(c.r) | static_cast<std::uint32_t>(c.g) << 8 | static_cast<std::uint32_t>(c.b) << 16;
}

}  // namespace packstone::viz
