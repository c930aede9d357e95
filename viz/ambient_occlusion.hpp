// Hollows between particles in shade, so that a packing reads as three-dimensional.
#pragma once

#include <cstddef>
#include <vector>

namespace packstone::viz {

/// Pixels beyond a window that its light depends on. reach [px]: the mean radius of the particles.
int occlusion_margin(double reach);

/// What the light is worked out of: linear over the picture of a plane. Parallel: the negative distance; perspective:
/// its inverse; less where something is farther.
std::vector<float> nearness_of(const std::vector<float>& distances, bool parallel);

/// How much light comes to a pixel by how far before it its neighbours lie: over pairs of opposite neighbours at
/// distances of 1, 2 and 4 reaches in eight directions, the mean of max(0, (c(d1) + c(d2)) / 2), where d is how much
/// nearer to the viewer a neighbour is, over its distance across, and c clamps to -1 ... 1. So planes up to 45 degrees
/// lose nothing, steeper ones little, and edges before a far ground nothing either. After Shanmugam and Arikan, Proc.
/// I3D (2007) 73, with opposite samples in pairs. A pixel's light does not depend on what window is drawn.
class HollowProbe {
 public:
  /// unit_per_pixel: length (parallel) or slope (perspective) that a pixel takes; stride: of the rows of pixels.
  HollowProbe(double reach, float unit_per_pixel, bool parallel, std::size_t stride);

  /// Of a row of pixels, whose nearness has occlusion_margin(reach) of others on all sides: 1 - strength times hollow.
  void light(const float* nearness, int width, float strength, float* light) const;

 private:
  struct Pair {
    std::ptrdiff_t offset;  // of one neighbour; the other's is its negative
    float per_unit;         // one over the distance across
  };
  std::vector<Pair> pairs_;
  bool parallel_;
};

}  // namespace packstone::viz
