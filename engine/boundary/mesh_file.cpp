#include "engine/boundary/mesh_file.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>

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

TriangleSurface surface_of(const std::string& path, vtkPolyData& mesh) {
  TriangleSurface surface;
  for (vtkIdType k = 0; k < mesh.GetNumberOfPoints(); ++k) surface.points.emplace_back(mesh.GetPoint(k));
  vtkCellArray* cells = mesh.GetPolys();
  check_corners(path, *cells, mesh.GetNumberOfPoints());
  for (vtkIdType k = 0; k < cells->GetNumberOfCells(); ++k) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(k, count, corners);
    if (count != 3) continue;
    surface.triangles.push_back({static_cast<std::int32_t>(corners[0]), static_cast<std::int32_t>(corners[1]),
                                 static_cast<std::int32_t>(corners[2])});
  }
  return surface;
}

template <class Rows>
std::string bytes_of(const Rows& rows) {
  return {reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(rows.front())};
}

template <class Rows>
void fill_from(std::string_view bytes, Rows& rows) {
  rows.resize(bytes.size() / sizeof(rows.front()));
  if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), bytes.data(), bytes.size());
}

/// VTK's readers may crash on a damaged file, or free what they never had: a process of its own reads it and hands over
/// the triangles. Their number, or 0 and why there are none, comes first.
TriangleSurface read_apart(const std::string& path) {
  const std::size_t memory = memory_at_least + memory_over_file_size * std::filesystem::file_size(path);
  const Trial trial = tried(memory, [&] {
    try {
      const TriangleSurface surface = surface_of(path, *read_by_extension(path));
      const std::uint64_t triangles[1] = {surface.triangles.size()};
      return bytes_of(std::span(triangles)) + bytes_of(surface.triangles) + bytes_of(surface.points);
    } catch (const InputError& error) {
      const std::uint64_t none[1] = {0};
      return bytes_of(std::span(none)) + error.what();
    }
  });
  if (!trial.failure.empty()) throw InputError(path + ": damaged: " + trial.failure);
  std::uint64_t count = 0;
  std::string_view rest = trial.result;
  if (rest.size() >= sizeof count) std::memcpy(&count, rest.data(), sizeof count);
  rest.remove_prefix(std::min(rest.size(), sizeof count));
  if (count == 0 && rest.starts_with(path)) throw InputError(std::string(rest));
  TriangleSurface surface;
  if (count == 0) return surface;
  const std::size_t bytes = count * sizeof surface.triangles.front();
  fill_from(rest.substr(0, bytes), surface.triangles);
  fill_from(rest.substr(bytes), surface.points);
  return surface;
}

}  // namespace

TriangleSurface read_mesh(const std::string& path, double scale, const Vec3& offset) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path + ": no such file");
  const formats::QuietVtk quiet;
  TriangleSurface surface = read_apart(path);
  for (std::size_t k = 0; k < surface.points.size(); ++k) {
    surface.points[k] = offset + scale * surface.points[k];
    if (!surface.points[k].allFinite()) throw InputError(fmt::format("{}: point {} is not finite", path, k));
  }
  surface = welded(surface);
  if (surface.triangles.empty()) {
    throw InputError(path + ": holds no triangles that could be read; is it a mesh of the kind its extension says?");
  }
  return surface;
}

}  // namespace packstone::engine
