// Boundaries of flat pieces: boxes, polygons, meshes, surfaces in triangles.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/boundary/shape.hpp"

namespace packstone::engine {

/// Triangles over shared points; corners are indices into points, in order around the normal.
struct TriangleSurface {
  std::vector<Vec3> points;  ///< [m]
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/// Points at the same place become one, and triangles without area go. Triangles may be oriented either way.
TriangleSurface welded(const TriangleSurface& surface);

/// The sides that bound only one triangle, or more than two, each as its two ends [m]; none of a closed surface.
std::vector<std::array<Vec3, 2>> open_sides(const TriangleSurface& surface);

/// Triangles turned so that those next to each other agree, and those of a closed surface face inwards.
TriangleSurface oriented_inwards(const TriangleSurface& surface);

/// Pieces such that a sphere touches a shared side or corner once. Surface as returned by welded.
Shape flat_shape(const TriangleSurface& surface);

/// A box's faces as plates; open: Face values that are left out.
Shape box_shape(const Vec3& min, const Vec3& max, const std::vector<int>& open);

/// What is wrong with a polygon that should be flat and convex, with three corners or more; empty: nothing.
std::string fault_of_polygon(const std::vector<Vec3>& corners);

/// Convex polygons in triangles.
TriangleSurface triangulated(const std::vector<std::vector<Vec3>>& polygons);

}  // namespace packstone::engine
