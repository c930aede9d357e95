// Stands in for vtk_file.cpp in a build without VTK.

#include "core/error.hpp"
#include "core/formats/vtk_file.hpp"

namespace packstone::formats {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw InputError(path.string() +
                   ": this build has no VTK to read it with; build with -DPACKSTONE_VIZ=ON, or export text");
}

}  // namespace

ParticleColumns read_vtk_file(const std::filesystem::path& path) { refuse(path); }

PairForces read_yade_interactions(const std::filesystem::path& path) { refuse(path); }

}  // namespace packstone::formats
