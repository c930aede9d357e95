// The plane of a slice: across an axis, or any.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/domain.hpp"
#include "core/vec3.hpp"

namespace packstone::viz {

/// A place in the plane: along its axis to the right and along that up [m].
struct InPlane {
  double u = 0;
  double v = 0;

  bool operator==(const InPlane&) const = default;
  auto operator<=>(const InPlane&) const = default;
};

/// The two axes in the plane across an axis: to the right and up in the picture.
struct PlaneAxes {
  int u;
  int v;
};
PlaneAxes axes_in_plane(int axis);

struct SlicePlane {
  std::optional<int> axis;     ///< 0 x, 1 y, 2 z; none of an oblique plane
  Vec3 normal;                 ///< unit vector
  double position = 0;         ///< normal . p of its points [m]
  Vec3 right, up;              ///< unit vectors in it
  Vec3 origin = Vec3::Zero();  ///< where u and v count from; of an oblique plane the point it was given by [m]

  /// The plane of all points whose coordinate along an axis has a value [m].
  SlicePlane(int across, double at);
  /// Through a point, with up as near to z as it goes, or to y where the plane is level. Throws InputError for a normal
  /// without a direction.
  SlicePlane(const Vec3& point, const Vec3& across);

  double height(const Vec3& p) const { return normal.dot(p) - position; }
  InPlane place(const Vec3& p) const { return {right.dot(p - origin), up.dot(p - origin)}; }
};

/// From "z=0.1", "y = 290 mm", or "through 0,0,100 mm normal 1,1,0". Throws InputError otherwise.
SlicePlane plane_from_text(const std::string& text);

/// "y = 290 mm", "through (0.1, 0.1, 0.2) m, normal (0.707, 0.707, 0)"; of an oblique plane also its two parts.
std::string plane_text(const SlicePlane& plane);
std::string through_text(const SlicePlane& plane);
std::string normal_text(const SlicePlane& plane);

/// "(0.71, -0.71, 0)", what is nothing beside the longest component being 0.
std::string vector_text(const Vec3& vector, int digits);

/// What the plane cuts out of the domain: the corners of a convex polygon in order; empty where it misses.
std::vector<InPlane> section(const Domain& domain, const SlicePlane& plane);

/// Distance of a place from a convex polygon, 0 inside [m].
double distance_from(const std::vector<InPlane>& polygon, const InPlane& place);

}  // namespace packstone::viz
