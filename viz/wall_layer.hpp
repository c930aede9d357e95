// The container as pixels with their distances, drawn by VTK: what the spheres stand before and behind.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/snapshot.hpp"
#include "viz/annotation.hpp"
#include "viz/camera.hpp"
#include "viz/pixel_window.hpp"

namespace packstone::viz {

/// Keeps its last picture: walls that stand still are drawn once. Large pictures are drawn in squares that do not
/// depend on the windows asked for, as OpenGL rounds differently in other places.
class WallLayer {
 public:
  /// Of a whole picture of width x height pixels, each of supersampling x supersampling samples.
  WallLayer(int width, int height, int supersampling, Ground ground);
  ~WallLayer();

  /// What the next pictures show. The camera is that of the samples; line_width is of the container's edges, in
  /// samples.
  void show(const Snapshot& snapshot, const UnitSpace& space, const Camera& camera, double line_width);

  /// Side of the squares that pictures are drawn in, in pixels of so many samples a side.
  static int patch_side(int supersampling) { return std::max(1, most_samples / supersampling); }

  /// Draws the square that holds the window of samples where needed. The window reaches over one only.
  void prepare(const PixelWindow& window);

  /// A row of the window prepared; the row counts from its top.
  struct Row {
    const std::uint32_t* colours;  ///< (width) red in the lowest byte, full in the highest; 0 where there is no wall
    const float* distances;        ///< (width) along the camera's axis from the viewer; infinite where there is no wall
  };
  Row row(int row) const;

 private:
  static constexpr int most_samples = 4096;
  static constexpr std::size_t most_kept = std::size_t{1} << 26;  ///< samples of all squares: 0.5 GB

  struct Stage;
  std::unique_ptr<Stage> stage_;
};

}  // namespace packstone::viz
