// Which triangles and edges of a boundary a picture shows.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/viz/packings.hpp"
#include "viz/surface.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

constexpr int sides = 64;

Camera camera(View view) { return {view, Vec3::Constant(-0.5), Vec3::Constant(0.5), {0, 0, 400, 300}}; }

SeenSurface seen(const BoundaryRecord& surface, View view) {
  return seen_surface(surface.points, surface.triangles, surface.one_sided, camera(view));
}

BoundaryRecord drum() { return testing::upright_cylinder(Vec3(0, 0, -0.4), 0.4, 0.8, sides); }

/// Normals point outwards.
BoundaryRecord cube() {
  BoundaryRecord cube;
  for (const Vec3& corner : box_corners(Vec3::Constant(-0.3), Vec3::Constant(0.3))) cube.points.push_back(corner);
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    cube.triangles.push_back({a, b, c});
    cube.triangles.push_back({a, c, d});
  }
  return cube;
}

}  // namespace

TEST_CASE("only what faces the viewer is drawn of a one-sided surface, all of a two-sided one") {
  BoundaryRecord surface = drum();
  // From the front the far half of the wall, less the two sides seen edge on; the floor is edge on.
  CHECK(seen(surface, View::front).triangles.size() == sides - 2);
  CHECK(seen(surface, View::top).triangles.size() == sides);  // the floor
  CHECK(seen(surface, View::bottom).triangles.empty());
  const SeenSurface iso = seen(surface, View::iso);
  for (const auto& normals : iso.normals) {
    for (const Vec3& n : normals) CHECK(n.norm() == Approx(1));
  }
  surface.one_sided = false;
  for (const View view : {View::front, View::top, View::bottom, View::iso}) {
    CHECK(seen(surface, view).triangles.size() == 3 * sides);
  }
}

TEST_CASE("lines are borders, creases and where the surface turns away, however the mesh is stored") {
  BoundaryRecord rounded = testing::cut_apart(drum());
  for (std::size_t i = 0; i < rounded.points.size(); ++i) rounded.points[i].x() += 1e-13 * static_cast<double>(i % 3);
  for (const BoundaryRecord& surface : {drum(), testing::cut_apart(drum()), rounded}) {
    // The rim has triangles on one side only, the floor meets the wall at 90 degrees; facets meet at 5.6 degrees.
    CHECK(seen(surface, View::bottom).lines.size() == 2 * sides);
    const SeenSurface front = seen(surface, View::front);
    std::vector<double> silhouette;
    for (const auto& [from, to] : front.lines) {
      const Vec3 along = front.points[to] - front.points[from];
      if (std::abs(along.z()) > 0.5) silhouette.push_back(front.points[from].x());
    }
    REQUIRE(silhouette.size() == 2);
    CHECK(std::abs(silhouette[0]) == Approx(0.4).epsilon(0.002));
    CHECK(silhouette[0] == Approx(-silhouette[1]));
    CHECK(front.lines.size() == 2 * sides + 2);
  }
  for (const bool one_sided : {true, false}) {
    BoundaryRecord surface = testing::cut_apart(cube());
    surface.one_sided = one_sided;
    CHECK(seen(surface, View::iso).lines.size() == 12);
    CHECK(seen(surface, View::iso).triangles.size() == (one_sided ? 6 : 12));
  }
}

TEST_CASE("a curved wall has the normals of the curve, a crease its own on either side") {
  const SeenSurface round = seen(drum(), View::iso);
  int off = 0;
  for (std::size_t t = 0; t < round.triangles.size(); ++t) {
    const bool floor = std::all_of(round.triangles[t].begin(), round.triangles[t].end(),
                                   [&](std::int32_t p) { return round.points[p].z() == -0.4; });
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 p = round.points[round.triangles[t][c]];
      const Vec3 expected = floor ? Vec3(Vec3::UnitZ()) : Vec3(-p.x(), -p.y(), 0).normalized();
      off += (round.normals[t][c] - expected).norm() > 1e-6;
    }
  }
  CHECK(off == 6);  // at each silhouette the last facet stands alone, with three corners
  const SeenSurface hidden_side = seen(cube(), View::top);
  REQUIRE(hidden_side.triangles.size() == 2);
  for (const Vec3& n : hidden_side.normals[0]) CHECK(n == Vec3::UnitZ());
}

TEST_CASE("triangles wound at random make a two-sided surface no rougher") {
  BoundaryRecord surface = cube();
  surface.one_sided = false;
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3)
    std::swap(surface.triangles[t][0], surface.triangles[t][1]);
  const SeenSurface turned = seen(surface, View::iso);
  CHECK(turned.lines.size() == 12);
  CHECK(turned.triangles.size() == 12);
  for (std::size_t t = 0; t < turned.triangles.size(); ++t) {
    const Vec3 p = turned.points[turned.triangles[t][0]];
    const bool faces = camera(View::iso).sees(p, turned.normals[t][0]);
    CHECK(faces);
  }
}

TEST_CASE("the edge of a blade is a line, though both sides look the same way in the picture") {
  BoundaryRecord blade;
  blade.one_sided = false;
  blade.points = {Vec3(0, -0.3, 0), Vec3(0, 0.3, 0), Vec3(0.4, 0, -0.02), Vec3(0.4, 0, 0.02)};
  blade.triangles = {{0, 1, 3}, {1, 0, 2}};
  CHECK(seen(blade, View::top).lines.size() == 5);
}

TEST_CASE("triangles without area draw nothing and break nothing") {
  BoundaryRecord surface = cube();
  const auto added = static_cast<std::int32_t>(surface.points.size());
  surface.points.push_back(Vec3(0, -0.3, -0.3));  // on the edge from 0 to 1
  surface.triangles.push_back({4, 4, 4});
  surface.triangles.push_back({0, 1, 1});
  CHECK(seen(surface, View::iso).lines.size() == 12);
  CHECK(seen(surface, View::iso).triangles.size() == 6);
  surface.triangles = {{0, added, 1}};
  CHECK(seen(surface, View::iso).triangles.empty());
  CHECK(seen_surface({}, {}, true, camera(View::iso)).lines.empty());
}

TEST_CASE("a sliver between two faces of a plane is not a line") {
  // A square whose lower half has one corner more on the diagonal, closed by a triangle without area.
  BoundaryRecord surface;
  surface.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0.5, 0.5, 0)};
  surface.triangles = {{0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {0, 4, 2}};
  CHECK(seen(surface, View::top).lines.size() == 4);
}

TEST_CASE("a hundred thousand triangles take no longer than sorting them") {
  constexpr int many = 33'334;
  const BoundaryRecord surface = testing::upright_cylinder(Vec3(0, 0, -0.4), 0.4, 0.8, many);
  CHECK(seen(surface, View::top).triangles.size() == many);
  CHECK(seen(testing::cut_apart(surface), View::top).lines.size() == 2 * many);
}
