// Spheres as a camera sees them: where in the picture, how far, in packets that can be left out as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/particle_view.hpp"
#include "viz/camera.hpp"
#include "viz/colouring.hpp"
#include "viz/cut_away.hpp"
#include "viz/cut_rays.hpp"
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

/// Spheres where they lie, in rows.
struct SphereRows {
  std::span<const Vec3> centres;
  std::span<const double> radii;  ///< of 0 nothing is drawn
  RowColours colours;
  std::vector<RowChunk> chunks;  ///< the rows to draw, ascending
  /// Lengths of the camera's space are (centre - origin) * scale.
  Vec3 origin = Vec3::Zero();
  double scale = 1;
  CutAway cut{};                                            ///< spheres with centres in it are not drawn
  bool cut_through = false;                                 ///< instead, only what lies in it is not
  std::function<void(const RowChunk&)> before_first_use{};  ///< of rows of a chunk
};

/// Of spheres in the camera's space, which must outlive the rows; (N) each.
SphereRows sphere_rows(std::span<const Vec3> centres, std::span<const double> radii, std::span<const Colour> colours);

/// The spheres of a picture, in packets of rows that stand near each other, as a snapshot's do, and these in chunks. Of
/// a chunk that is not seen no row is looked at.
class SphereCloud {
 public:
  /// What the rows refer to must outlive the cloud. first_number: of row 0.
  SphereCloud(SphereRows rows, const Camera& camera, std::uint32_t first_number = 0);

  const Camera& camera() const { return camera_; }
  /// Chunks, the nearest first.
  const std::vector<Packet>& packets() const { return chunks_; }
  /// Of a chunk, the nearest first; none of a packet. Throws what before_first_use throws.
  std::span<const Packet> parts_of(const Packet& packet) const;

  /// The spheres of a packet that reach into the window, the nearest first, without those that reach nearer to the
  /// viewer than the camera allows.
  void find(const Packet& packet, const PixelWindow& window, std::vector<Candidate>& found) const;
  SeenSphere seen(const Candidate& candidate) const;

  /// Whether a sphere shows a face of the cut, and what rays cross of that.
  bool shows_cut(const Candidate& candidate) const {
    return rows_.cut_through && share_cut(candidate.row) == CutShare::part;
  }
  CutRays cut_rays() const { return {rows_.cut, rows_.origin, rows_.scale, camera_}; }
  /// Of the camera's space, as Camera::seen_from_eye.
  Vec3 centre_seen(const Candidate& candidate) const {
    return camera_.seen_from_eye(in_space(rows_.centres[candidate.row]));
  }
  double radius(const Candidate& candidate) const { return rows_.radii[candidate.row] * rows_.scale; }

 private:
  CutShare share_cut(std::size_t row) const { return cut_share(rows_.cut, rows_.centres[row], rows_.radii[row]); }
  bool is_left_out(std::size_t row) const {
    return rows_.cut_through ? share_cut(row) == CutShare::all : is_cut_away(rows_.cut, rows_.centres[row]);
  }
  Vec3 in_space(const Vec3& place) const { return (place - rows_.origin) * rows_.scale; }
  Outline outline_of_rows(std::size_t first, std::size_t last) const;
  template <bool parallel>
  void find_outlines(const Packet& packet, std::vector<Candidate>& found) const;

  SphereRows rows_;
  Camera camera_;
  std::uint32_t first_number_;
  std::vector<Packet> chunks_;
  mutable std::unordered_map<std::size_t, std::vector<Packet>> opened_;  // by first row: the packets of a chunk
};

}  // namespace packstone::viz
