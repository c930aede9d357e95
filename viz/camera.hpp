// Where the viewer stands: the domain fills a given part of the picture, whatever the particles do, so movies stand
// still.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/vec3.hpp"
#include "viz/drawing.hpp"

class vtkCamera;

namespace packstone::viz {

/// Along an axis the projection is parallel, so that lengths can be read off; iso has a mild perspective.
enum class View { iso, front, back, left, right, top, bottom };

/// Throws InputError that lists the views there are.
View view_named(const std::string& name);

/// Around the vertical from the front to the right, and up [rad].
struct Turn {
  double azimuth;
  double elevation;

  bool operator==(const Turn&) const = default;
};

/// From where and how closely a picture looks.
struct Viewpoint {
  View view = View::iso;
  std::optional<Turn> turn;   ///< instead of the view, with its mild perspective
  double zoom = 1;            ///< larger than where all of the domain fits
  std::optional<Vec3> focus;  ///< stands in the middle [m]; the domain's centre

  Viewpoint() = default;
  Viewpoint(View named) : view(named) {}

  bool perspective() const { return turn.has_value() || view == View::iso; }
  /// Whether parts of the domain may be out of view.
  bool close() const { return zoom != 1 || focus.has_value(); }

  bool operator==(const Viewpoint&) const = default;
};

/// "top", or "AZIMUTH,ELEVATION" in degrees: 90,0 is from the right, 0,90 from above. Throws InputError.
Viewpoint viewpoint_from_text(const std::string& text);

/// The corners of an axis-aligned box; corner i has the upper end along axis k where bit k of i is set.
std::array<Vec3, 8> box_corners(const Vec3& min, const Vec3& max);

/// Maps points in space to pixels: x to the right, y down.
class Camera {
 public:
  /// The box just fits into the region. Lengths of space are of the order of 1. The viewpoint's zoom and focus do not
  /// count: see look_closer.
  Camera(const Viewpoint& viewpoint, const Vec3& min, const Vec3& max, const Box& region);

  Point project(const Vec3& p) const;
  bool parallel() const { return parallel_; }
  /// Pixels that a length of 1 across the line of sight takes at the origin, or at a point.
  double pixels_per_unit() const { return pixels_per_unit_at(Vec3::Zero()); }
  double pixels_per_unit_at(const Vec3& p) const;
  /// How near a point is to the viewer, along the line of sight: more is nearer.
  double height(const Vec3& p) const { return axes_[2].dot(p); }
  /// Unit vectors in space: to the right, up, and from the scene to the viewer.
  const std::array<Vec3, 3>& axes() const { return axes_; }
  /// True when a viewer sees the side of the plane that the normal points to.
  bool sees(const Vec3& point, const Vec3& normal) const;

  /// The pixel at which the viewer looks straight.
  Point centre() const { return centre_; }
  /// Pixels per unit length (parallel), per unit slope (perspective).
  double focal() const { return focal_; }
  /// Of a point, from the viewer: to the right, down, away from him.
  Vec3 seen_from_eye(const Vec3& p) const {
    return {axes_[0].dot(p) - at_.x(), at_.y() - axes_[1].dot(p), at_.z() - axes_[2].dot(p)};
  }
  /// The point that a pixel shows at a distance from the viewer along the line of sight.
  Vec3 point_at(Point pixel, double distance) const;
  /// What lies nearer than this, along the line of sight, or farther than that is not drawn.
  double nearest_distance() const;
  double farthest_distance() const;

  /// Enlarges the picture around the pixel looked straight at, to which a point in space is brought where one is given.
  void look_closer(double zoom, const std::optional<Vec3>& focus);
  /// Shifts the picture sideways.
  void move_right(double pixels) { centre_.x += pixels; }
  /// The camera of the same picture in pixels a factor smaller, or of the part of it that begins at a pixel.
  Camera finer(int factor) const;
  Camera of_part(Point corner) const;

  bool operator==(const Camera&) const = default;

  /// Sets VTK's camera for a picture of this size.
  void apply(vtkCamera& camera, int width, int height) const;

 private:
  void fit_parallel(const std::array<Vec3, 8>& corners, const Box& region);
  void fit_perspective(const std::array<Vec3, 8>& corners, const Box& region);
  Vec3 eye() const;

  std::array<Vec3, 3> axes_;
  bool parallel_;
  Point centre_;
  double focal_ = 1;
  Vec3 at_ = Vec3::Zero();  ///< the viewer's place along the axes
  double nearest_ = 0;      ///< of the box along the axis to the viewer
  double farthest_ = 0;
};

}  // namespace packstone::viz
