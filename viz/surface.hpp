// What a picture shows of a boundary's triangles: those to draw, how they are lit, and the edges worth a line.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec3.hpp"
#include "viz/camera.hpp"

namespace packstone::viz {

/// Corners, as indices into points.
using Triangle = std::array<std::int32_t, 3>;

/// A surface as one camera sees it.
struct SeenSurface {
  std::vector<Vec3> points;                        ///< of the surface; those that coincide are one
  std::vector<Triangle> triangles;                 ///< to be drawn
  std::vector<std::array<Vec3, 3>> normals;        ///< unit vectors at their corners, to the viewer's side
  std::vector<std::array<std::int32_t, 2>> lines;  ///< edges to be drawn, as indices into points
};

/// Of a one-sided surface only the triangles that face the viewer are drawn. Lines are the edges of one triangle,
/// creases, and outlines: where a surface turns away from the viewer. Normals are those of the triangle and of the
/// neighbours around the corner up to the next line. Points are in the camera's space. O(T log T).
SeenSurface seen_surface(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, bool one_sided,
                         const Camera& camera);

}  // namespace packstone::viz
