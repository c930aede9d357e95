// The free surface: heights in closed form, by brute force over spheres and columns, and what it makes of flat beds.
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include "analysis/surface/rolling_ball.hpp"
#include "analysis/surface/surface_file.hpp"
#include "core/error.hpp"
#include "tests/analysis/fixtures.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;

namespace {

constexpr double grain = 1, ball = 3;  // radii [m]

analysis::SurfaceHeights rolled(const Snapshot& s, const analysis::Options& options) {
  const auto context = analysis::make_context(s, options);
  const auto container = analysis::container_of(s, context.frame);
  return analysis::free_surface(s, context, container, analysis::surface_step(s, context, container));
}

/// Of a ball of radius p that rolls on the floor about a sphere of radius r on it, at a distance from its axis: the
/// sphere, the fillet between the two points the ball touches, the floor.
double fillet_height(double r, double p, double distance) {
  const double rest = 2 * std::sqrt(r * p);  // of the ball that touches both, from the axis
  const double touch = rest * r / (r + p);
  if (distance <= touch) return r + std::sqrt(r * r - distance * distance);
  return distance < rest ? p - std::sqrt(p * p - (rest - distance) * (rest - distance)) : 0;
}

double fillet_volume(double r, double p) {
  constexpr int rings = 200'000;
  const double width = 2 * std::sqrt(r * p) / rings;
  double volume = 0;
  for (int k = 0; k < rings; ++k) {
    const double distance = (k + 0.5) * width;
    volume += 2 * std::numbers::pi * distance * width * fillet_height(r, p, distance);
  }
  return volume;
}

BoundaryRecord can(const Vec3& bottom, double radius) {
  BoundaryRecord record{.name = "can", .kind = "cylinder", .point = bottom, .normal = Vec3::UnitZ()};
  record.axis = Vec3::UnitZ();
  record.cross_section = std::numbers::pi * radius * radius;
  return record;
}

/// Spheres of many sizes strewn over a floor, some of them across periodic sides.
Snapshot strewn(std::array<bool, 3> periodic) {
  Snapshot s = empty_box(Vec3(6, 5, 20), periodic);
  Random random(11, RandomStream::filling_position, 0);
  for (int i = 0; i < 120; ++i) {
    const double r = i == 0 ? 1.4 : std::exp2(random.uniform(-4, -0.5));
    add_particle(s, Vec3(random.uniform(0, 6), random.uniform(0, 5), random.uniform(r, 2)), r);
  }
  return s;
}

/// Height of the surface over one column of the grid, from its definition with nothing left out.
double plain_height(const Snapshot& s, const analysis::SurfaceHeights& grid, std::size_t column) {
  const auto middle = [&](std::size_t k) {
    return Vec3(grid.origin[0] + grid.step[0] * static_cast<double>(k % grid.count[0]),
                grid.origin[1] + grid.step[1] * static_cast<double>(k / grid.count[0]), 0);
  };
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < grid.columns(); ++k) {
    Vec3 offset = s.domain.separation(middle(column), middle(k));
    const double under = grid.probe * grid.probe - offset.head<2>().squaredNorm();
    if (under < 0) continue;
    double centre = grid.probe;
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (int image = 0; image < 9; ++image) {
        Vec3 d = s.position[i] - middle(k);
        if (s.domain.periodic[0]) d.x() += (image % 3 - 1) * s.domain.size().x();
        if (s.domain.periodic[1]) d.y() += (image / 3 - 1) * s.domain.size().y();
        const double reach = s.radius[i] + grid.probe;
        const double rise = reach * reach - d.head<2>().squaredNorm();
        if (rise > 0) centre = std::max(centre, s.position[i].z() + std::sqrt(rise));
      }
    }
    lowest = std::min(lowest, centre - std::sqrt(under));
  }
  return lowest;
}

}  // namespace

TEST_CASE("the surface about a sphere on the floor is sphere, fillet, floor, and converges with the step") {
  Snapshot s = empty_box(Vec3(10, 10, 8), {false, false, false});
  add_particle(s, Vec3(5, 5, grain), grain);
  const double expected = fillet_volume(grain, ball);
  double before = 0;
  for (const double step : {0.2, 0.1, 0.05, 0.025}) {
    const auto result = measured(s, "surface", {.surface_probe = ball, .surface_step = step});
    const double error = value(result, "surface_volume") / expected - 1;
    INFO("step " << step << ", error " << error);
    CHECK(error > -1e-3);  // never too low, but for the sum over columns
    CHECK(error < 0.6 * step);
    if (before > 0) CHECK(error < 0.75 * before);
    CHECK(std::abs(error) * expected < 2 * *result.quantity("surface_volume")->uncertainty);
    before = error;
  }
  const auto surface = rolled(s, {.surface_probe = ball, .surface_step = 0.025});
  double worst = 0;
  for (std::size_t k = 0; k < surface.columns(); ++k) {
    const double x = surface.origin[0] + surface.step[0] * static_cast<double>(k % surface.count[0]) - 5;
    const double y = surface.origin[1] + surface.step[1] * static_cast<double>(k / surface.count[0]) - 5;
    const double off = surface.height[k] - fillet_height(grain, ball, std::hypot(x, y));
    CHECK(off > -1e-12);
    worst = std::max(worst, off);
  }
  CHECK(worst < 0.05);
}

TEST_CASE("a round bed counts the columns inside, the area is the circle's") {
  Snapshot s = empty_box(Vec3(8, 8, 8), {false, false, false});
  s.boundaries = {can(Vec3(4, 4, 0), 3.8)};
  add_particle(s, Vec3(4, 4, grain), grain);
  const auto result = measured(s, "surface", {.surface_probe = ball, .surface_step = 0.02});
  CHECK(value(result, "surface_volume") == Approx(fillet_volume(grain, ball)).epsilon(0.004));
  CHECK(value(result, "surface_height") * 3.8 * 3.8 * std::numbers::pi == Approx(value(result, "surface_volume")));
  CHECK(value(result, "surface_fraction") ==
        Approx(4.0 / 3 * std::numbers::pi / value(result, "surface_volume")).epsilon(1e-12));
}

TEST_CASE("a ball rests in the hollows of a lattice") {
  // On four spheres of a square with edges 2: sqrt(2) from each of their axes.
  const Snapshot s = cubic_bed(6, 6, 3);
  const auto result = measured(s, "surface", {.surface_probe = 2, .surface_step = 0.05});
  const double rest = 5 + std::sqrt(9.0 - 2.0) - 2;
  CHECK(value(result, "surface_lowest") == Approx(rest).margin(0.02));
  CHECK(value(result, "surface_lowest") > rest - 1e-5);
  CHECK(value(result, "surface_highest") == Approx(6).margin(1e-3));
  CHECK(value(result, "surface_volume") < 6 * 144);
  CHECK(value(result, "surface_volume") > rest * 144);
}

TEST_CASE("every column has the height of the definition, whatever spheres and columns are left out") {
  for (const std::array<bool, 3> periodic : {std::array{true, true, false}, std::array{false, true, false}}) {
    const Snapshot s = strewn(periodic);
    for (const double probe : {0.15, 0.9}) {
      const auto surface = rolled(s, {.surface_probe = probe, .surface_step = 0.1});
      REQUIRE(surface.columns() == 60 * 50);
      double worst = 0;
      for (std::size_t k = 0; k < surface.columns(); k += 37) {
        worst = std::max(worst, std::abs(surface.height[k] - plain_height(s, surface, k)));
      }
      CHECK(worst < 1e-12);
    }
  }
}

TEST_CASE("the surface is the same whichever way is up and wherever periodic sides cut") {
  Snapshot s = strewn({true, true, false});
  const analysis::Options options{.surface_probe = 0.5, .surface_step = 0.1};
  const double volume = value(measured(s, "surface", options), "surface_volume");

  Snapshot turned = s;  // z becomes -x
  const auto turn = [](const Vec3& v) { return Vec3(-v.z(), v.x(), v.y()); };
  for (Vec3& p : turned.position) p = turn(p);
  turned.gravity = turn(s.gravity);
  turned.domain = {Vec3(-20, 0, 0), Vec3(0, 6, 5), {false, true, true}};
  CHECK(value(measured(turned, "surface", options), "surface_volume") == Approx(volume).epsilon(1e-12));

  for (Vec3& p : s.position) p = s.domain.wrapped(p + Vec3(2.3, 4.1, 0));  // whole steps
  CHECK(value(measured(s, "surface", options), "surface_volume") == Approx(volume).epsilon(1e-12));
}

TEST_CASE("the surface of a flat bed agrees with base times height") {
  for (const int layers : {4, 8, 16}) {
    const Snapshot s = lattice(face_centred, 5, 5, layers, std::sqrt(8.0), 1 + 5e-7, {true, true, false});
    const auto result = measured(s, "surface");
    const double off = std::abs(value(result, "surface_volume") / value(result, "base_height_volume") - 1);
    CHECK(off < 0.002);  // the second paper has 0.05
    CHECK(value(result, "surface_roughness") < 0.2);
  }
}

TEST_CASE("where there is no surface the measure says so") {
  const auto reason = [](const Snapshot& s) {
    const auto result = measured(s, "surface");
    for (const auto& quantity : result.quantities) CHECK_FALSE(quantity.value);
    return result.quantity("surface_volume")->note;
  };
  CHECK_THAT(reason(empty_box(Vec3(1, 1, 1))), Contains("no particles"));
  CHECK_THAT(reason(cubic_bed(2, 2, 2, {true, true, true})), Contains("periodic along up"));
  Snapshot s = empty_box(Vec3(4, 4, 4));
  add_particle(s, Vec3(1, 1, 1), 0);
  CHECK_THAT(reason(s), Contains("all radii are 0"));

  const testing::TemporaryFolder folder;
  CHECK_THROWS_WITH(analysis::write_surface(folder / "a.vtp", s, {}), Contains("no free surface"));
  CHECK_THROWS_WITH(analysis::write_surface(folder / "a.ply", cubic_bed(2, 2, 2), {}), Contains("must end in .vtp"));
  CHECK_THROWS_WITH(measured(cubic_bed(2, 2, 2), "surface", {.surface_step = 1e-5}), Contains("--surface-step"));
  CHECK_THROWS_WITH(measured(s, "surface", {.surface_probe = -1}), Contains("surface's probe"));
  CHECK(std::filesystem::is_empty(folder.path()));
}
