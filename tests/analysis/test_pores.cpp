// Pore sizes: distances to all surfaces, lattices, walls.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "analysis/structure/void_spheres.hpp"
#include "core/error.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/random_packings.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

double brute_radius(const Snapshot& s, const Vec3& p) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < s.size(); ++i) {
    nearest = std::min(nearest, s.domain.separation(s.position[i], p).norm() - s.radius[i]);
  }
  return nearest;
}

}  // namespace

TEST_CASE("void spheres touch the nearest particle at any size ratio") {
  const auto periodic = GENERATE(std::array{false, false, false}, std::array{true, true, true});
  Snapshot s = ideal_gas(300, Vec3(10, 9, 11), periodic, 8);
  Random random(2, RandomStream::particle_radius, 0);
  for (double& r : s.radius) r = 0.01 * std::pow(100, random.uniform());
  s.radius[4] = 0;
  const VoidSpheres spheres(s);
  for (int k = 0; k < 500; ++k) {
    const Vec3 p(random.uniform(0, 10), random.uniform(0, 9), random.uniform(0, 11));
    CHECK(spheres.radius_at(p) == Approx(brute_radius(s, p)).margin(1e-12));
  }
}

TEST_CASE("void spheres stop at planes and triangles") {
  Snapshot s = empty_box(Vec3(10, 10, 10), {false, false, false});
  add_particle(s, Vec3(9, 9, 9), 0.1);
  SECTION("plane") {
    s.boundaries = {{"slope", "plane", Vec3(0, 0, 1), Vec3(0, 0.6, 0.8)}};
    CHECK(VoidSpheres(s).radius_at(Vec3(3, 1, 1)) == Approx(0.6));
  }
  SECTION("triangle: face, edges, corners, either side") {
    BoundaryRecord plate{"plate", "mesh"};
    plate.points = {Vec3(2, 2, 2), Vec3(4, 2, 2), Vec3(2, 5, 2)};
    plate.triangles = {{0, 1, 2}};
    s.boundaries = {plate};
    const VoidSpheres spheres(s);
    CHECK(spheres.radius_at(Vec3(2.5, 2.5, 3)) == Approx(1));
    CHECK(spheres.radius_at(Vec3(2.5, 2.5, 1.5)) == Approx(0.5));
    CHECK(spheres.radius_at(Vec3(3, 1, 1)) == Approx(std::sqrt(2.0)));                 // beside the edge y = 2
    CHECK(spheres.radius_at(Vec3(5, 1, 2)) == Approx(std::sqrt(2.0)));                 // beyond a corner
    CHECK(spheres.radius_at(Vec3(3 + 0.3, 3.5 + 0.2, 2)) == Approx(std::sqrt(0.13)));  // beside the slanted edge
  }
  SECTION("twelve triangles are the box they make") {
    const BoundaryRecord box = prism(4, Vec3(5, 5, 0), 4, -10, 20);
    s.boundaries = {box};
    const VoidSpheres spheres(s);
    // A square on its corner: |x| + |y| = 4, the sides at 4/sqrt(2) from the axis.
    CHECK(spheres.radius_at(Vec3(5, 5, 5)) == Approx(4 / std::sqrt(2.0)));
    CHECK(spheres.radius_at(Vec3(6, 5.5, 5)) == Approx((4 - 1.5) / std::sqrt(2.0)));
  }
}

TEST_CASE("the pores of a simple cubic lattice") {
  // Edge 1, radius 0.3: spheres of radius 0.3 + r around the sites do not overlap up to r = 0.2.
  const double radius = 0.3;
  const Snapshot s = lattice(simple_cubic, 5, 5, 5, 1.0, radius);
  const int points = 400'000;
  const auto result = measured(s, "pores", {.pore_points = points});
  const double void_share = 1 - sphere_volume(radius);
  const Quantity& share = *result.quantity("void_fraction");
  CHECK(*share.uncertainty == Approx(std::sqrt(void_share * (1 - void_share) / points)).epsilon(0.01));
  CHECK(std::abs(*share.value - void_share) < 4 * *share.uncertainty);

  const double n = std::round(*share.value * points);
  for (const auto& row : result.table("pore_distribution")->rows) {
    if (row[0] > 0.2) break;
    const double above = (1 - sphere_volume(radius + row[0])) / void_share;
    CHECK(std::abs(row[5] - above) < 4 * std::sqrt(above * (1 - above) / n) + 1e-12);
    if (row[1] > 0.2) break;
    const double inside = (sphere_volume(radius + row[1]) - sphere_volume(radius + row[0])) / void_share;
    CHECK(std::abs(row[3] - inside / (row[1] - row[0])) < 4 * row[4]);
  }

  // Mean by the midpoint rule over an eighth of a cell.
  const int grid = 150;
  double sum = 0, squares = 0, count = 0;
  for (int i = 0; i < grid; ++i) {
    for (int j = 0; j < grid; ++j) {
      for (int k = 0; k < grid; ++k) {
        const double r = Vec3(i + 0.5, j + 0.5, k + 0.5).norm() * 0.5 / grid - radius;
        if (r <= 0) continue;
        sum += r;
        squares += r * r;
        ++count;
      }
    }
  }
  const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
  const Quantity& found = *result.quantity("pore_radius_mean");
  CHECK(*found.uncertainty == Approx(deviation / std::sqrt(n)).epsilon(0.01));
  CHECK(std::abs(*found.value - mean) < 4 * *found.uncertainty);
  const double corner = std::sqrt(3.0) / 2 - radius;
  CHECK(value(result, "pore_radius_max") <= corner);
  CHECK(value(result, "pore_radius_max") > 0.95 * corner);
  // The median from its definition: half of the void is nearer than m, the ball's caps beyond the six faces not counted.
  const auto within = [&](double m) {
    const double R = radius + m, h = std::max(0.0, R - 0.5);
    return sphere_volume(R) - 6 * EIGEN_PI * h * h * (3 * R - h) / 3;
  };
  const double half = sphere_volume(radius) + void_share / 2;
  double low = 0, high = 0.3;
  while (high - low > 1e-12) (within((low + high) / 2) < half ? low : high) = (low + high) / 2;
  const Quantity& middle = *result.quantity("pore_radius_median");
  CHECK(std::abs(*middle.value - low) < 4 * *middle.uncertainty);
  // sqrt(1/4 n) over the density of radii there.
  const double density = (within(low + 1e-6) - within(low - 1e-6)) / 2e-6 / void_share;
  CHECK(*middle.uncertainty == Approx(0.5 / std::sqrt(n) / density).epsilon(0.2));
}

TEST_CASE("a lone particle in a box of walls: pores end at the walls") {
  Snapshot s = empty_box(Vec3(4, 4, 4), {false, false, false});
  add_particle(s, Vec3(2, 2, 2), 1e-6);
  for (int k = 0; k < 3; ++k) {
    s.boundaries.push_back({"low", "plane", Vec3::Zero(), Vec3::Unit(k)});
    s.boundaries.push_back({"high", "plane", Vec3::Constant(4), -Vec3::Unit(k)});
  }
  s.domain.periodic[2] = true;  // the whole height is the window
  const auto result = measured(s, "pores", {.pore_points = 50'000});
  const auto& rows = result.table("pore_distribution")->rows;
  // Far from the particle, at most 0.5 from a wall: (1 - 2 r/4)^3 of the box is farther than r.
  for (const auto& row : rows) {
    if (row[0] > 0.5) break;
    const double above = std::pow(1 - row[0] / 2, 3);
    CHECK(std::abs(row[5] - above) < 4 * std::sqrt(above * (1 - above) / 50'000) + 1e-12);
  }
  CHECK(value(result, "pore_radius_max") < 2);
}

TEST_CASE("pores where there are none") {
  CHECK(measured(empty_box(Vec3(1, 1, 1)), "pores").quantity("void_fraction")->note == "no particles");
  Snapshot full = empty_box(Vec3(4, 4, 4), {true, true, true});
  add_particle(full, Vec3(2, 2, 2), 4);
  const auto result = measured(full, "pores");
  CHECK(value(result, "void_fraction") == 0);
  CHECK(result.quantity("pore_radius_mean")->note == "no point lies in the void");
  CHECK(result.table("pore_distribution")->rows.empty());
  CHECK_THROWS_AS(measured(full, "pores", {.pore_points = 1}), InputError);
}
