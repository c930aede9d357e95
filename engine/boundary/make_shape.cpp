#include "engine/boundary/make_shape.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/boundary/flat_shape.hpp"
#include "engine/boundary/mesh_file.hpp"
#include "engine/boundary/round_shape.hpp"
#include "engine/boundary/surface_shape.hpp"

namespace packstone::engine {

namespace {

/// Of the smallest radius: how far a surface's triangles may be from the formula.
constexpr double tolerance_share = 0.01;

std::string text_of(const Vec3& p) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", p[0], p[1], p[2]); }

Shape plane_shape(const BoundarySpec& b) {
  Shape shape;
  const Vec3 normal = b.normal->normalized();
  shape.pieces.emplace_back(PlanePiece{normal, normal.dot(*b.point)});
  shape.record.point = *b.point;
  shape.record.normal = normal;
  shape.finish();
  return shape;
}

/// Records the floor of a box: the face that gravity points to.
void record_floor(BoundaryRecord& record, const Scene& scene, const BoundarySpec& b) {
  int axis = 2;
  if (scene.gravity.present) scene.gravity.acceleration.cwiseAbs().maxCoeff(&axis);
  const bool up = !scene.gravity.present || scene.gravity.acceleration[axis] <= 0;
  const Vec3 size = *b.max - *b.min;
  record.axis = Vec3::Unit(axis);
  record.cross_section = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  if (std::count(b.open.begin(), b.open.end(), 2 * axis + (up ? 0 : 1)) > 0) return;
  record.point = up ? *b.min : *b.max;
  record.normal = (up ? 1 : -1) * Vec3::Unit(axis);
}

/// Of polygons or a mesh: with an inside if the scene says so, which takes a closed surface.
Shape solid_shape(const Scene& scene, const std::string& path, const BoundarySpec& b, const TriangleSurface& surface) {
  if (b.side == Side::both) return flat_shape(surface);
  const auto open = open_sides(surface);
  if (!open.empty()) {
    scene.fail(path + ".side",
               fmt::format("\"{}\" needs a closed surface; this one has a hole or a fold at {} of its sides, the first "
                           "from {} to {}; close it, or take side = \"both\"",
                           b.side == Side::inside ? "inside" : "outside", open.size(), text_of(open[0][0]),
                           text_of(open[0][1])));
  }
  return flat_shape(oriented_inwards(surface));
}

void check_polygons(const Scene& scene, const std::string& path, const BoundarySpec& b) {
  for (std::size_t k = 0; k < b.polygons.size(); ++k) {
    const std::string fault = fault_of_polygon(b.polygons[k]);
    if (!fault.empty()) scene.fail(path + ".polygons", fmt::format("polygon {} {}", k, fault));
  }
}

double tolerance_of(const Scene& scene, const std::string& path, const BoundarySpec& b) {
  if (b.tolerance) return *b.tolerance;
  if (scene.filling.kind == FillingKind::file) {
    scene.fail(path,
               "needs tolerance, how far the triangles may be from the formula [m]: the particles' radii are not "
               "known before their file is read");
  }
  double smallest = scene.size_range(0).smallest;
  for (std::size_t g = 1; g < scene.particles.size(); ++g) smallest = std::min(smallest, scene.size_range(g).smallest);
  return tolerance_share * smallest;
}

Shape shape_of_kind(const Scene& scene, const std::string& path, const BoundarySpec& b, const Domain& domain) {
  switch (b.kind) {
    case BoundaryKind::box: {
      Shape shape = box_shape(*b.min, *b.max, b.open);
      record_floor(shape.record, scene, b);
      return shape;
    }
    case BoundaryKind::cylinder:
    case BoundaryKind::cone:
    case BoundaryKind::funnel:
      return round_shape(b, domain);
    case BoundaryKind::surface:
      return flat_shape(b.grid ? surface_of_grid(*b.grid)
                               : surface_of_formula(scene, path, *b.formula, tolerance_of(scene, path, b)));
    case BoundaryKind::polygons:
      check_polygons(scene, path, b);
      return solid_shape(scene, path, b, welded(triangulated(b.polygons)));
    case BoundaryKind::mesh:
      return solid_shape(scene, path, b, read_mesh(*b.path, b.scale.value_or(1), b.offset.value_or(Vec3::Zero())));
    case BoundaryKind::plane:
      break;
  }
  return plane_shape(b);
}

}  // namespace

Shape make_shape(const Scene& scene, std::size_t boundary, const Domain& domain) {
  const BoundarySpec& b = scene.boundaries[boundary];
  Shape shape = shape_of_kind(scene, fmt::format("boundary[{}]", boundary), b, domain);
  shape.repeats = b.kind == BoundaryKind::surface || b.kind == BoundaryKind::polygons || b.kind == BoundaryKind::mesh;
  shape.record.name = b.name;
  if (b.kind != BoundaryKind::plane) shape.side = b.side;
  shape.record.one_sided = shape.side != Side::both || shape.is_plane();
  if (b.side == Side::outside) {
    for (auto& triangle : shape.record.triangles) std::swap(triangle[1], triangle[2]);
  }
  return shape;
}

}  // namespace packstone::engine
