// Spheres as pixels: every pixel's ray met with every sphere that can be seen on it, without OpenGL, so that a pixel's
// bytes depend on the spheres alone and not on the part of the picture or of the spheres that is drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "viz/camera.hpp"
#include "viz/pixel_window.hpp"
#include "viz/sphere_cloud.hpp"

namespace packstone::viz {

/// What is seen in every pixel of a window.
class SphereLayer {
 public:
  static constexpr std::uint32_t nothing = 0xffffffff;

  explicit SphereLayer(const Camera& camera);

  /// Empties it, for a window.
  void reset(const PixelWindow& window);
  /// Whether nothing was drawn; its rows may not be asked for then.
  bool blank() const { return blank_; }

  /// Draws spheres over what is there; the order of draws does not matter. With cull those that others hide cost
  /// little; the pixels are the same.
  void draw(const SphereCloud& cloud, bool cull = true);

  /// Takes what is nearer of another layer of the same window.
  void merge(const SphereLayer& other);

  /// Darkens what stands in hollows by up to strength (0 to 1): see ambient_occlusion.hpp. reach: of the smallest
  /// hollows, in pixels. From then on the layer is that of the inner window, which keeps occlusion_margin(reach) from
  /// the sides of the whole.
  void occlude(double strength, double reach, const PixelWindow& inner);

  const PixelWindow& window() const { return window_; }
  /// Of a row of the window (width): distance along the camera's axis from the viewer, infinite where nothing is.
  const float* distances(int row) const { return &distance_[at(row)]; }
  /// Lit colour, red in the lowest byte, full in the highest; 0 where nothing is.
  const std::uint32_t* colours(int row) const { return &colour_[at(row)]; }
  /// SeenSphere::number, or nothing.
  const std::uint32_t* numbers(int row) const { return &number_[at(row)]; }

 private:
  class Horizon;

  void fill();
  std::size_t at(int row) const { return offset_ + static_cast<std::size_t>(row) * stride_; }
  template <bool parallel>
  void draw(const SeenSphere& sphere);

  PixelWindow window_;
  bool parallel_;
  float unit_per_pixel_;  // length (parallel) or slope (perspective) that a pixel takes
  bool blank_ = true;
  std::size_t stride_ = 0, offset_ = 0;  // the latter of the window's first pixel
  std::vector<float> distance_;
  std::vector<std::uint32_t> colour_, number_;
};

}  // namespace packstone::viz
