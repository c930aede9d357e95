// Spheres as a camera sees them: where in the picture, how far, in packets that can be left out as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "viz/camera.hpp"
#include "viz/outline.hpp"

namespace packstone::viz {

/// A sphere as the camera sees it.
struct SeenSphere {
  int column, row;         ///< of the pixel whose middle is nearest to the picture of its centre
  float right, down;       ///< of that middle, where the centre is [px]
  float slope_x, slope_y;  ///< of the line of sight to the centre, to the right and down; 0 in parallel projection
  float distance;          ///< of the centre along the camera's axis, from the viewer
  float radius;
  Outline outline;
  std::uint32_t colour;  ///< red in the lowest byte, then green, blue
  std::uint32_t number;  ///< where two spheres meet in a pixel, the lower one is seen
};

/// The spheres of a picture, in packets of rows that stand near each other, as a snapshot's do.
class SphereCloud {
 public:
  /// centres and radii in the camera's space, colours: (N) each; they must outlive the cloud. first_number: of the
  /// first row, where they are a part of more.
  SphereCloud(std::span<const Vec3> centres, std::span<const double> radii, std::span<const Colour> colours,
              const Camera& camera, std::uint32_t first_number = 0);

  const Camera& camera() const { return camera_; }
  /// The nearest first.
  const std::vector<Packet>& packets() const { return packets_; }

  /// The spheres of a packet that reach into the window, the nearest first, without those that reach nearer to the
  /// viewer than the camera allows.
  void find(const Packet& packet, const PixelWindow& window, std::vector<Candidate>& found) const;
  SeenSphere seen(const Candidate& candidate) const;

 private:
  template <bool parallel>
  void find_outlines(const Packet& packet, std::vector<Candidate>& found) const;

  std::span<const Vec3> centres_;
  std::span<const double> radii_;
  std::span<const Colour> colours_;
  Camera camera_;
  std::uint32_t first_number_;
  std::vector<Packet> packets_;
};

}  // namespace packstone::viz
