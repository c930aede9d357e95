// Straight round bodies as a camera sees them: tubes, cones, and what lies between, with flat ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "viz/outline.hpp"

namespace packstone::viz {

/// A circular frustum: a tube where both radii are the same, a cone where one is 0.
struct Frustum {
  Vec3 from, to;
  double from_radius, to_radius;
  Colour colour;
};

/// A frustum as the camera sees it, in the camera's axes: x to the right, y down, z away from the viewer.
struct SeenFrustum {
  Vec3 from;
  Vec3 axis;  ///< unit vector to the other end
  double length;
  double from_radius, to_radius;
  Outline outline;
  std::uint32_t colour, number;
  Point ends[2];                   ///< pixels about which the ends lie
  double half_width, half_height;  ///< that either end reaches from there at most [px]
};

/// The frusta of a picture, in packets of rows.
class FrustumCloud {
 public:
  /// frusta in the camera's space; they must outlive the cloud. first_number: of the first row.
  FrustumCloud(std::span<const Frustum> frusta, const Camera& camera, std::uint32_t first_number);

  const Camera& camera() const { return camera_; }
  /// The nearest first.
  const std::vector<Packet>& packets() const { return packets_; }
  std::span<const Packet> parts_of(const Packet&) const { return {}; }

  /// Those of a packet that reach into the window, the nearest first, without those of no length and those that reach
  /// nearer to the viewer than the camera allows.
  void find(const Packet& packet, const PixelWindow& window, std::vector<Candidate>& found) const;
  SeenFrustum seen(const Candidate& candidate) const;

 private:
  PixelReach reach_of_end(const Vec3& end, double radius) const;

  std::span<const Frustum> frusta_;
  Camera camera_;
  std::uint32_t first_number_;
  std::vector<Packet> packets_;
};

}  // namespace packstone::viz
