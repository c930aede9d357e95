// The lines in which a slice cuts the boundaries.
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/viz/packings.hpp"
#include "viz/boundary_cut.hpp"
#include "viz/slice_drawing.hpp"
#include "viz/svg.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

Snapshot box_with(const BoundaryRecord& boundary) {
  Snapshot snapshot = testing::empty_box(Vec3(1, 1, 2));
  snapshot.boundaries = {boundary};
  return snapshot;
}

BoundaryRecord plane(const Vec3& point, const Vec3& normal) { return {"wall", "plane", point, normal.normalized()}; }

double length(const CutLine& line) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    sum += std::hypot(line[i + 1].u - line[i].u, line[i + 1].v - line[i].v);
  }
  return sum;
}

}  // namespace

TEST_CASE("a cylinder is cut across its axis in one closed ring at its radius") {
  constexpr double a = 0.4;
  constexpr int sides = 48;
  const BoundaryRecord drum = testing::upright_cylinder(Vec3(0.5, 0.45, 0.1), a, 1.5, sides);
  for (const BoundaryRecord& stored : {drum, testing::cut_apart(drum)}) {
    const auto lines = boundary_cut(box_with(stored), {2, 0.7});
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].front() == lines[0].back());
    CHECK(lines[0].size() == 2 * sides + 1);  // every quad of the wall is cut in two triangles
    for (const auto& [u, v] : lines[0]) {
      const double distance = std::hypot(u - 0.5, v - 0.45);
      CHECK(distance <= a * (1 + 1e-12));
      CHECK(distance >= a * std::cos(M_PI / sides) * (1 - 1e-12));
    }
    CHECK(length(lines[0]) == Approx(2 * sides * a * std::sin(M_PI / sides)));
  }
}

TEST_CASE("a cylinder is cut along its axis in walls and floor") {
  constexpr double a = 0.4;
  const auto lines = boundary_cut(box_with(testing::upright_cylinder(Vec3(0.5, 0.5, 0.1), a, 1.5, 48)), {1, 0.5});
  REQUIRE(lines.size() == 1);
  CHECK(length(lines[0]) == Approx(2 * 1.5 + 2 * a * std::cos(M_PI / 48)));
  CHECK(lines[0].front().v == Approx(1.6));
  CHECK(lines[0].back().v == Approx(1.6));
}

TEST_CASE("nothing is cut beyond the ends, beside the domain, or in the plane itself") {
  const Snapshot snapshot = box_with(testing::upright_cylinder(Vec3(0.5, 0.5, 0.1), 0.4, 1.5, 48));
  CHECK(boundary_cut(snapshot, {2, 0.05}).empty());
  CHECK(boundary_cut(snapshot, {2, 1.65}).empty());
  CHECK(boundary_cut(snapshot, {2, 0.1}).empty());  // the floor lies in it, the wall above
  CHECK(boundary_cut(box_with(testing::upright_cylinder(Vec3(3, 0.5, 0.1), 0.4, 1.5, 48)), {2, 1}).empty());
}

TEST_CASE("triangles without area and corners that just touch are no lines") {
  BoundaryRecord odd;
  odd.kind = "mesh";
  odd.points = {Vec3(0.2, 0.2, 1), Vec3(0.4, 0.2, 1), Vec3(0.3, 0.3, 0.5), Vec3(0.2, 0.2, 0.5), Vec3(0.9, 0.9, 1)};
  odd.triangles = {{0, 0, 0}, {0, 1, 4}, {0, 0, 3}, {2, 3, 0}};
  CHECK(boundary_cut(box_with(odd), {2, 1}).empty());
  odd.triangles = {{0, 1, 2}};  // an edge in the plane, the rest below
  const auto lines = boundary_cut(box_with(odd), {2, 1});
  REQUIRE(lines.size() == 1);
  CHECK(length(lines[0]) == Approx(0.2));
  CHECK_NOTHROW(draw_slice(box_with(odd), {2, 1}, {}));
}

TEST_CASE("a plane is cut in a line from side to side of the domain") {
  const auto diagonal = boundary_cut(box_with(plane(Vec3(0.5, 0.5, 1), Vec3(1, 0, -1))), {1, 0.3});
  REQUIRE(diagonal.size() == 1);
  CHECK(length(diagonal[0]) == Approx(std::sqrt(2.0)));
  for (const auto& [x, z] : diagonal[0]) CHECK(z == Approx(x + 0.5));
  // It moves with the slice where it is not square to it.
  const auto shifted = boundary_cut(box_with(plane(Vec3(0.2, 0, 0), Vec3(1, 0, -1))), {2, 0.5});
  REQUIRE(shifted.size() == 1);
  for (const auto& [x, y] : shifted[0]) CHECK(x == Approx(0.7));
  CHECK(length(shifted[0]) == Approx(1));

  CHECK(boundary_cut(box_with(plane(Vec3(0, 0, 0.3), Vec3::UnitZ())), {2, 0.3}).empty());
  CHECK(boundary_cut(box_with(plane(Vec3(1.2, 0, 0), Vec3::UnitX())), {2, 0.3}).empty());
  // The domain's own sides are drawn as the frame.
  CHECK(boundary_cut(box_with(plane(Vec3::Zero(), Vec3::UnitZ())), {1, 0.3}).empty());
  CHECK(boundary_cut(box_with(plane(Vec3(0, 0, 0.1), Vec3::UnitZ())), {1, 0.3}).size() == 1);
}

TEST_CASE("pixels and SVG of a slice show the wall where it is cut") {
  Snapshot snapshot = box_with(testing::upright_cylinder(Vec3(0.5, 0.5, 0.1), 0.4, 1.5, 48));
  SliceOptions options;
  options.width = 400;
  options.height = 300;
  const SlicePlane slice{2, 1};
  const Drawing drawing = slice_drawing(snapshot, slice, options);
  const LineMark* ring = nullptr;
  for (const Mark& mark : drawing.marks) {
    const auto* line = std::get_if<LineMark>(&mark);
    if (line != nullptr && line->stroke.colour == wall_edge) ring = line;
  }
  REQUIRE(ring != nullptr);
  CHECK(ring->points.size() == 98);  // and one point twice, to close it
  const Image image = draw_slice(snapshot, slice, options);
  int dark = 0;
  for (const Point& p : ring->points) dark += image.at(static_cast<int>(p.x), static_cast<int>(p.y)).r < 220;
  CHECK(dark == 98);
  snapshot.boundaries.clear();
  const std::string with = svg_text(drawing, "");
  const std::string without = svg_text(slice_drawing(snapshot, slice, options), "");
  CHECK(with.find("stroke='#6e6e6e'") != std::string::npos);
  CHECK(without.find("stroke='#6e6e6e'") == std::string::npos);
}
