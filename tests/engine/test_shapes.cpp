// Shapes of boundaries: nearest points against formulas and against each other.
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "engine/boundary/flat_shape.hpp"
#include "engine/boundary/make_shape.hpp"
#include "hand_made.hpp"

using namespace packstone;
using namespace packstone::engine;
using engine::testing::contact_scene;

namespace {

constexpr double far_away = 10;

Vec3 random_point(Random& random, double low, double high) {
  return {random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
}

/// The smallest distance at which a sphere about p touches, and how many pieces it touches there.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::Zero();
  int pieces = 0;
};
Nearest nearest(const Shape& shape, const Vec3& p) {
  Nearest found;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(shape.pieces.size()); ++k) {
    std::int8_t side = shape.side_of(k, p);
    Touch touch;
    if (!shape.touch(k, p, far_away, side, touch)) continue;
    ++found.pieces;
    if (touch.distance < found.distance) found = {touch.distance, touch.normal, found.pieces};
  }
  return found;
}

/// Of its pieces' distances, each as if it were alone.
double least_distance(const Shape& shape, const Vec3& p) {
  double least = far_away;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(shape.pieces.size()); ++k) {
    least = std::min(least, shape.distance(k, p));
  }
  return least;
}

Shape shape_from(const std::string& boundary) {
  const Scene scene =
      contact_scene("normal = \"linear\"\n", "restitution = 0.5\n", false, "[[boundary]]\nname = \"b\"\n" + boundary);
  return make_shape(scene, 0, scene.box());
}

/// Distance from the surface of a box, on either side.
double box_distance(const Vec3& min, const Vec3& max, const Vec3& p) {
  const Vec3 outside = (min - p).cwiseMax(p - max);
  if (outside.maxCoeff() > 0) return outside.cwiseMax(0).norm();
  return -outside.maxCoeff();
}

/// From a triangle, by the closest of its points on a fine net.
double sampled_distance(const TriangleSurface& s, const Vec3& p) {
  constexpr int net = 200;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : s.triangles) {
    for (int i = 0; i <= net; ++i) {
      for (int j = 0; i + j <= net; ++j) {
        const double u = double(i) / net, v = double(j) / net;
        const Vec3 q = (1 - u - v) * s.points[t[0]] + u * s.points[t[1]] + v * s.points[t[2]];
        least = std::min(least, (p - q).norm());
      }
    }
  }
  return least;
}

}  // namespace

TEST_CASE("a box is as far as the formula says, inside, outside, at edges and corners") {
  const Vec3 min(0.2, 0.3, 0.1), max(0.7, 0.6, 0.9);
  const Shape shape = shape_from("kind = \"box\"\nmin = [0.2, 0.3, 0.1]\nmax = [0.7, 0.6, 0.9]\n");
  CHECK(shape.pieces.size() == 12 + 12 + 8);  // triangles, edges and corners: diagonals of faces are no edges
  Random random(1, RandomStream::filling_position, 0);
  for (int n = 0; n < 3000; ++n) {
    const Vec3 p = random_point(random, -0.2, 1.2);
    const Nearest found = nearest(shape, p);
    REQUIRE(found.distance == Approx(box_distance(min, max, p)).epsilon(1e-12));
    REQUIRE(least_distance(shape, p) == Approx(found.distance).epsilon(1e-12));
    // A step along the normal leads straight away from it.
    REQUIRE(box_distance(min, max, p - 0.5 * found.distance * found.normal) ==
            Approx(0.5 * found.distance).epsilon(1e-9));
    REQUIRE(shape.allows(p) == ((p - min).minCoeff() >= 0 && (max - p).minCoeff() >= 0));
  }
}

TEST_CASE("a surface of triangles is as far as the nearest of its points") {
  TriangleSurface s;
  Random random(2, RandomStream::filling_position, 0);
  for (int n = 0; n < 9; ++n) s.points.push_back(random_point(random, 0, 1));
  s.triangles = {{0, 1, 2}, {2, 1, 3}, {3, 1, 4},
                 {2, 3, 5}, {5, 3, 6}, {6, 7, 8}};  // a strip, a fan, a flap at a corner
  const Shape shape = flat_shape(welded(s));
  for (int n = 0; n < 200; ++n) {
    const Vec3 p = random_point(random, -0.5, 1.5);
    const double sampled = sampled_distance(s, p);
    REQUIRE(nearest(shape, p).distance == Approx(sampled).margin(1e-4));
    REQUIRE(nearest(shape, p).distance <= sampled + 1e-12);
    REQUIRE(least_distance(shape, p) == Approx(nearest(shape, p).distance).epsilon(1e-12));
  }
}

TEST_CASE("a cylinder with a lid is as far as its profile says") {
  const Shape shape =
      shape_from("kind = \"cylinder\"\npoint = [0.5, 0.5, 0.2]\nradius = 0.3\nlength = 0.6\nclosed = [\"bottom\"]\n");
  Random random(3, RandomStream::filling_position, 0);
  for (int n = 0; n < 3000; ++n) {
    const Vec3 p = random_point(random, -0.2, 1.2);
    const double r = std::hypot(p.x() - 0.5, p.y() - 0.5), z = p.z();
    const double wall = std::hypot(r - 0.3, std::max({0.2 - z, z - 0.8, 0.0}));
    const double lid = std::hypot(std::max(r - 0.3, 0.0), z - 0.2);
    REQUIRE(nearest(shape, p).distance == Approx(std::min(wall, lid)).margin(1e-14));
    REQUIRE(least_distance(shape, p) == Approx(std::min(wall, lid)).margin(1e-14));
    REQUIRE(shape.allows(p) == (r < 0.3 && z >= 0.2));
  }
}

TEST_CASE("round shapes about a tilted axis are as far as their facets, within the facets' sagitta") {
  const std::string axis = "point = [0.5, 0.5, 0.3]\naxis = [1, 2, 3]\n";
  const std::string which = GENERATE(
      "kind = \"cylinder\"\nradius = 0.2\nlength = 0.5\n",
      "kind = \"cone\"\nradius = 0.3\ntop_radius = 0.1\nlength = 0.4\nclosed = [\"bottom\", \"top\"]\n",
      "kind = \"funnel\"\nradius = 0.3\noutlet_radius = 0.1\ncone_length = 0.3\nlength = 0.2\ntube_length = 0.1\n");
  INFO(which);
  const Shape shape = shape_from(which + axis);
  TriangleSurface facets{shape.record.points, {}};
  facets.triangles.assign(shape.record.triangles.begin(), shape.record.triangles.end());
  const Shape flat = flat_shape(welded(facets));
  const double sagitta = 0.3 * (1 - std::cos(std::numbers::pi / 96));
  Random random(4, RandomStream::filling_position, 0);
  for (int n = 0; n < 1000; ++n) {
    const Vec3 p = random_point(random, -0.2, 1.2);
    REQUIRE(nearest(shape, p).distance == Approx(least_distance(flat, p)).margin(1.0001 * sagitta));
  }
}

TEST_CASE("where a sphere rolls, its normal turns as its shape says") {
  const Shape shape = shape_from(
      "kind = \"funnel\"\npoint = [0.5, 0.5, 0.3]\naxis = [1, 2, 3]\nradius = 0.3\noutlet_radius = 0.1\n"
      "cone_length = 0.3\nlength = 0.2\n");
  const Shape box = shape_from("kind = \"box\"\nmin = [0.2, 0.3, 0.1]\nmax = [0.7, 0.6, 0.9]\n");
  Random random(5, RandomStream::filling_position, 0);
  for (const Shape* s : {&shape, &box}) {
    int turned = 0;
    for (int n = 0; n < 2000; ++n) {
      const Vec3 p = random_point(random, 0, 1), step = 1e-6 * random_point(random, -1, 1);
      for (std::int32_t k = 0; k < static_cast<std::int32_t>(s->pieces.size()); ++k) {
        std::int8_t side = s->side_of(k, p);
        Touch here, there;
        if (!s->touch(k, p, far_away, side, here) || here.distance < 0.05) continue;
        if (!s->touch(k, p + step, far_away, side, there)) continue;
        const Vec3 across = step - step.dot(here.normal) * here.normal;
        const Vec3 expected = here.turning * across + here.turning_along * across.dot(here.direction) * here.direction;
        REQUIRE((there.normal - here.normal - expected).norm() < 5e-3 * step.norm());
        turned += expected.norm() > 0 ? 1 : 0;
      }
    }
    CHECK(turned > 500);
  }
}

TEST_CASE("a centre pressed through a plate is pressed back, one that went round its edge is not") {
  const Shape plate = flat_shape(welded(triangulated({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}})));
  std::int8_t side = 1;
  Touch touch;
  const Vec3 above(0.3, 0.6, 0.01), below(0.3, 0.6, -0.01);
  std::int32_t piece = 0;
  while (!plate.touch(piece, above, 0.02, side, touch)) ++piece;
  CHECK(touch.distance == Approx(0.01));
  REQUIRE(plate.touch(piece, below, 0.02, side, touch));
  CHECK(touch.distance == Approx(-0.01));
  CHECK(touch.normal.z() == 1);
  // Round the edge, out of touch with the plate's face.
  CHECK_FALSE(plate.touch(piece, Vec3(-0.01, 0.6, -0.005), 0.02, side, touch));
  REQUIRE(plate.touch(piece, below, 0.02, side, touch));
  CHECK(touch.distance == Approx(0.01));
  CHECK(touch.normal.z() == -1);
}

TEST_CASE("a point is within a closed surface whatever its triangles' order, and above a floor") {
  const Shape tetrahedron = shape_from(
      "kind = \"polygons\"\nside = \"inside\"\npolygons = [[[0.1,0.1,0.1],[0.9,0.1,0.1],[0.1,0.9,0.1]], "
      "[[0.1,0.1,0.1],[0.9,0.1,0.1],[0.1,0.1,0.9]], [[0.1,0.1,0.1],[0.1,0.9,0.1],[0.1,0.1,0.9]], "
      "[[0.9,0.1,0.1],[0.1,0.9,0.1],[0.1,0.1,0.9]]]\n");
  const Shape floor = shape_from("kind = \"surface\"\nformula = \"0.3 + 0.1*x*y\"\ntolerance = 1e-3\n");
  Random random(6, RandomStream::filling_position, 0);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p = random_point(random, 0, 1);
    const Vec3 q = p - Vec3::Constant(0.1);
    REQUIRE(tetrahedron.allows(p) == (q.minCoeff() > 0 && q.sum() < 0.8));
    if (std::abs(p.z() - 0.3 - 0.1 * p.x() * p.y()) > 1e-3) {
      REQUIRE(floor.allows(p) == (p.z() > 0.3 + 0.1 * p.x() * p.y()));
    }
  }
}

TEST_CASE("a surface's triangles keep to the tolerance, with no more of them than it takes") {
  const auto triangles = [](const std::string& tolerance) {
    const Shape s =
        shape_from("kind = \"surface\"\nformula = \"0.2 + 0.05*sin(2*pi*x)\"\ntolerance = " + tolerance + "\n");
    double off = 0;
    for (const auto& t : s.record.triangles) {
      Vec3 middle = Vec3::Zero();
      for (const auto corner : t) middle += s.record.points[corner] / 3;
      off = std::max(off, std::abs(middle.z() - 0.2 - 0.05 * std::sin(2 * std::numbers::pi * middle.x())));
    }
    CHECK(off <= std::stod(tolerance));
    return s.record.triangles.size();
  };
  const auto coarse = triangles("1e-3"), fine = triangles("1e-4");
  CHECK(fine > coarse);
  CHECK(fine < 8 * coarse);  // half the cell along x quarters the error; y needs nothing
}

TEST_CASE("polygons that are none are refused with what is wrong") {
  CHECK(fault_of_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).empty());
  CHECK_THAT(fault_of_polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), Catch::Contains("no area"));
  CHECK_THAT(fault_of_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}), Catch::Contains("not flat"));
  CHECK_THAT(fault_of_polygon({{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}}), Catch::Contains("not convex"));
  CHECK_THAT(fault_of_polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}), Catch::Contains("twice"));
}
