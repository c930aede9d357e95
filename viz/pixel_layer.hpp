// What is seen in every pixel of a window: how far it is, its colour, and the number of the body. Bodies are drawn over
// it ray by ray, without OpenGL (sphere_drawing.hpp, frustum_drawing.hpp), so that a pixel's bytes depend on the bodies
// alone and not on the part of the picture or of the bodies that is drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "viz/camera.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::viz {

/// From a pixel on to the right.
struct PixelRun {
  float* distance;
  std::uint32_t* colour;
  std::uint32_t* number;
};

class PixelLayer {
 public:
  static constexpr std::uint32_t nothing = 0xffffffff;
  static constexpr int room = 16;  ///< pixels behind every row that may be drawn on, for whole vectors

  explicit PixelLayer(const Camera& camera);

  /// Empties it, for a window.
  void reset(const PixelWindow& window);
  /// Whether nothing was drawn; its rows may not be asked for then.
  bool blank() const { return blank_; }

  /// Before the first body is drawn.
  void make_drawable() {
    if (blank_) fill();
  }
  /// Of the picture's row and column, in the window. Where two bodies meet in a pixel the lower number is seen, so that
  /// the order of drawing does not matter.
  PixelRun run(int row, int column) {
    const std::size_t first = at(row - window_.top) + static_cast<std::size_t>(column - window_.left);
    return {&distance_[first], &colour_[first], &number_[first]};
  }

  /// Takes what is nearer of another layer of the same window.
  void merge(const PixelLayer& other);

  /// Darkens what stands in hollows by up to strength (0 to 1): see ambient_occlusion.hpp. reach: of the smallest
  /// hollows, in pixels. From then on the layer is that of the inner window, which keeps occlusion_margin(reach) from
  /// the sides of the whole.
  void occlude(double strength, double reach, const PixelWindow& inner);

  const PixelWindow& window() const { return window_; }
  /// Of a row of the window (width): distance along the camera's axis from the viewer, infinite where nothing is.
  const float* distances(int row) const { return &distance_[at(row)]; }
  /// Lit colour, red in the lowest byte, full in the highest; 0 where nothing is.
  const std::uint32_t* colours(int row) const { return &colour_[at(row)]; }
  /// Of the bodies, or nothing.
  const std::uint32_t* numbers(int row) const { return &number_[at(row)]; }

 private:
  void fill();
  std::size_t at(int row) const { return offset_ + static_cast<std::size_t>(row) * stride_; }

  PixelWindow window_;
  bool parallel_;
  float unit_per_pixel_;  // length (parallel) or slope (perspective) that a pixel takes
  bool blank_ = true;
  std::size_t stride_ = 0, offset_ = 0;  // the latter of the window's first pixel
  std::vector<float> distance_;
  std::vector<std::uint32_t> colour_, number_;
};

}  // namespace packstone::viz
