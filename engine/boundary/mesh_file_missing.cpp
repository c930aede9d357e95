// Stands in for mesh_file.cpp in a build without VTK.

#include "core/error.hpp"
#include "engine/boundary/mesh_file.hpp"

namespace packstone::engine {

TriangleSurface read_mesh(const std::string& path, double, const Vec3&) {
  throw InputError(path +
                   ": this build has no VTK to read meshes with; build with -DPACKSTONE_VIZ=ON, or give polygons");
}

}  // namespace packstone::engine
