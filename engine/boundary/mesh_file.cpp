#include "engine/boundary/mesh_file.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include "core/error.hpp"
#include "core/formats/quiet_vtk.hpp"
#include "core/trial.hpp"

namespace packstone::engine {

namespace {

constexpr std::size_t memory_at_least = std::size_t{256} << 20;  ///< [bytes], of VTK itself and small files
constexpr std::size_t memory_over_file_size = 64;                ///< of text, and of the filter's copies

/// VTK's filters trust the readers, which pass on any number that a file has.
void check_corners(const std::string& path, vtkCellArray& cells, vtkIdType points) {
  for (vtkIdType k = 0; k < cells.GetNumberOfCells(); ++k) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells.GetCellAtId(k, count, corners);
    for (vtkIdType c = 0; c < count; ++c) {
      if (corners[c] >= 0 && corners[c] < points) continue;
      throw InputError(fmt::format("{}: polygon {} refers to point {}; there are {}", path, k, corners[c], points));
    }
  }
}

template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(const std::string& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* const mesh = reader->GetOutput();
  check_corners(path, *mesh->GetPolys(), mesh->GetNumberOfPoints());
  check_corners(path, *mesh->GetStrips(), mesh->GetNumberOfPoints());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkPolyData> read_by_extension(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".stl" || extension == ".STL") return read_with<vtkSTLReader>(path);
  if (extension == ".obj" || extension == ".OBJ") return read_with<vtkOBJReader>(path);
  if (extension == ".ply" || extension == ".PLY") return read_with<vtkPLYReader>(path);
  if (extension == ".vtk") return read_with<vtkPolyDataReader>(path);
  throw InputError(
      fmt::format("{}: \"{}\" is no mesh's extension; .stl, .obj, .ply and .vtk are read", path, extension));
}

}  // namespace

TriangleSurface read_mesh(const std::string& path, double scale, const Vec3& offset) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path + ": no such file");
  const formats::QuietVtk quiet;
  // VTK's readers may crash on a damaged file, so they have a try at it first.
  const std::string failure = failure_in_trial(
      memory_at_least + memory_over_file_size * std::filesystem::file_size(path), [&] { read_by_extension(path); });
  if (!failure.empty()) throw InputError(path + ": damaged: " + failure);
  const vtkSmartPointer<vtkPolyData> mesh = read_by_extension(path);
  TriangleSurface surface;
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k) {
    const Vec3 p = offset + scale * Vec3(mesh->GetPoint(k));
    if (!p.allFinite()) throw InputError(fmt::format("{}: point {} is not finite", path, k));
    surface.points.push_back(p);
  }
  vtkCellArray* cells = mesh->GetPolys();
  for (vtkIdType k = 0; k < cells->GetNumberOfCells(); ++k) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(k, count, corners);
    if (count != 3) continue;
    surface.triangles.push_back({static_cast<std::int32_t>(corners[0]), static_cast<std::int32_t>(corners[1]),
                                 static_cast<std::int32_t>(corners[2])});
  }
  surface = welded(surface);
  if (surface.triangles.empty()) {
    throw InputError(path + ": holds no triangles that could be read; is it a mesh of the kind its extension says?");
  }
  return surface;
}

}  // namespace packstone::engine
