#include "viz/occlusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace packstone::viz {

namespace {

constexpr double safety = 1;  ///< [px] for the rounding of the renderer's single precision

/// A coarse picture of squares; each knows the depth behind which nothing shows in all of the square.
class Cover {
 public:
  Cover(int width, int height, double side)
      : side_(side),
        columns_(static_cast<int>(std::ceil(width / side))),
        rows_(static_cast<int>(std::ceil(height / side))),
        depth_(static_cast<std::size_t>(columns_) * rows_, -std::numeric_limits<double>::infinity()) {}

  /// A disc that faces the viewer, at a height above the ground (more is nearer).
  void add(Point centre, double radius, double height) {
    const double reach = radius - safety;
    if (reach <= 0) return;
    const int top = clamped((centre.y - reach) / side_, rows_);
    const int bottom = clamped((centre.y + reach) / side_, rows_);
    for (int row = top; row < bottom; ++row) {
      // The chord that fits on both the upper and the lower edge of the row of squares.
      const double off = std::max(std::abs(row * side_ - centre.y), std::abs((row + 1) * side_ - centre.y));
      if (off >= reach) continue;
      const double half_chord = std::sqrt(reach * reach - off * off);
      const int left = clamped(std::ceil((centre.x - half_chord) / side_), columns_);
      const int right = clamped(std::floor((centre.x + half_chord) / side_), columns_);
      for (int column = left; column < right; ++column) {
        double& depth = depth_[static_cast<std::size_t>(row) * columns_ + column];
        depth = std::max(depth, height);
      }
    }
  }

  /// True when all of a box is covered, and the box lies below the cover.
  bool hides(const Box& box, double height) const {
    const int top = clamped((box.top - safety) / side_, rows_);
    const int bottom = clamped(std::ceil((box.bottom + safety) / side_), rows_);
    const int left = clamped((box.left - safety) / side_, columns_);
    const int right = clamped(std::ceil((box.right + safety) / side_), columns_);
    for (int row = top; row < bottom; ++row) {
      const auto first = depth_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
      if (std::any_of(first + left, first + right, [&](double depth) { return depth <= height; })) return false;
    }
    return true;
  }

 private:
  static int clamped(double place, int count) { return static_cast<int>(std::clamp<double>(place, 0, count)); }

  double side_;
  int columns_;
  int rows_;
  std::vector<double> depth_;
};

/// Pixels that a sphere surely stays within.
Box outer_box(const Vec3& centre, double radius, const Camera& camera) {
  Box box{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int i = 0; i < 8; ++i) {
    Vec3 corner = centre;
    for (int k = 0; k < 3; ++k) corner += ((i >> k & 1) != 0 ? radius : -radius) * camera.axes()[k];
    const Point p = camera.project(corner);
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
  }
  return box;
}

/// Squares small against most spheres, so that spheres fill them, yet few.
double square_side(const std::vector<double>& radii, const Camera& camera) {
  constexpr double per_radius = 16;
  constexpr double smallest = 2;
  std::vector<double> sorted = radii;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return std::max(smallest, *middle * camera.pixels_per_unit() / per_radius);
}

}  // namespace

std::vector<std::size_t> visible_rows(const std::vector<Vec3>& centres, const std::vector<double>& radii,
                                      const Camera& camera, int width, int height) {
  std::vector<std::size_t> visible;
  if (centres.empty()) return visible;
  // Every sphere covers at least the disc through its centre that faces the viewer, and lies nearer there.
  Cover cover(width, height, square_side(radii, camera));
  for (std::size_t i = 0; i < centres.size(); ++i) {
    cover.add(camera.project(centres[i]), radii[i] * camera.pixels_per_unit_at(centres[i]), camera.height(centres[i]));
  }
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double nearest = camera.height(centres[i]) + radii[i];
    if (!cover.hides(outer_box(centres[i], radii[i], camera), nearest)) visible.push_back(i);
  }
  return visible;
}

}  // namespace packstone::viz
