#include "analysis/surface/surface_file.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/surface/rolling_ball.hpp"
#include "core/error.hpp"
#include "core/formats/vtk_appended.hpp"

namespace packstone::analysis {

namespace {

constexpr std::int64_t no_point = -1;
constexpr std::int64_t triangle_corners = 3;

struct SurfaceMesh {
  std::vector<Vec3> point;  // [m]
  std::vector<double> height;
  std::vector<std::int64_t> corner;  // of the triangles, one after the other
};

SurfaceMesh mesh_of(const SurfaceHeights& surface, const BedFrame& frame) {
  SurfaceMesh mesh;
  std::vector<std::int64_t> point_of(surface.columns(), no_point);
  for (std::size_t k = 0; k < surface.columns(); ++k) {
    if (std::isnan(surface.height[k])) continue;
    Vec3 point;
    point[surface.across[0]] = surface.origin[0] + surface.step[0] * static_cast<double>(k % surface.count[0]);
    point[surface.across[1]] = surface.origin[1] + surface.step[1] * static_cast<double>(k / surface.count[0]);
    point[frame.axis] = frame.floor + frame.sign * surface.height[k];
    point_of[k] = static_cast<std::int64_t>(mesh.point.size());
    mesh.point.push_back(point);
    mesh.height.push_back(surface.height[k]);
  }
  const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    if (a == no_point || b == no_point || c == no_point) return;
    if (frame.sign < 0) std::swap(b, c);
    mesh.corner.insert(mesh.corner.end(), {a, b, c});
  };
  for (std::size_t j = 0; j + 1 < surface.count[1]; ++j) {
    for (std::size_t i = 0; i + 1 < surface.count[0]; ++i) {
      const std::size_t k = i + surface.count[0] * j;
      const std::int64_t here = point_of[k], right = point_of[k + 1], over = point_of[k + surface.count[0]],
                         across = point_of[k + surface.count[0] + 1];
      add(here, right, across);
      add(here, across, over);
    }
  }
  return mesh;
}

void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh) {
  std::vector<std::int64_t> ends;
  for (std::size_t k = triangle_corners; k <= mesh.corner.size(); k += triangle_corners) {
    ends.push_back(static_cast<std::int64_t>(k));
  }
  formats::TextOutput out(path);
  formats::VtkAppended data(out);
  out.print(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n<PointData "
      "Scalars=\"height\">\n",
      mesh.point.size(), ends.size());
  data.declare("height", "Float64", 1, mesh.height.data(), mesh.height.size());
  out.print("</PointData>\n<Points>\n");
  data.declare("Points", "Float64", 3, mesh.point.front().data(), 3 * mesh.point.size());
  out.print("</Points>\n<Polys>\n");
  data.declare("connectivity", "Int64", 1, mesh.corner.data(), mesh.corner.size());
  data.declare("offsets", "Int64", 1, ends.data(), ends.size());
  out.print("</Polys>\n</Piece>\n</PolyData>\n");
  data.write();
  out.print("</VTKFile>\n");
  out.finish();
}

}  // namespace

void write_surface(const std::filesystem::path& path, const Snapshot& snapshot, const Options& options) {
  if (path.extension() != ".vtp") throw InputError(path.string() + ": a surface's name must end in .vtp");
  const Context context = make_context(snapshot, options);
  const Container container = container_of(snapshot, context.frame);
  const double step = surface_step(snapshot, context, container);
  const SurfaceHeights surface = free_surface(snapshot, context, container, step);
  if (surface.columns() == 0)
    throw InputError(path.string() + ": the packing has no free surface (see measure surface)");
  write_mesh(path, mesh_of(surface, context.frame));
}

}  // namespace packstone::analysis
