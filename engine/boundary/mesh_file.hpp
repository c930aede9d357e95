// Meshes of triangles from files.
#pragma once

#include <string>

#include "engine/boundary/flat_shape.hpp"

namespace packstone::engine {

/// Reads STL, OBJ, PLY or (legacy) VTK, told apart by the file's extension; polygons in triangles, welded. Throws
/// InputError that names the file; also in a build without VTK.
TriangleSurface read_mesh(const std::string& path, double scale, const Vec3& offset);

}  // namespace packstone::engine
