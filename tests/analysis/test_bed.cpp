// Bulk fraction and bed height.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/bed.hpp"
#include "core/bed_frame.hpp"
#include "core/error.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;

namespace {

constexpr double cubic_fraction = std::numbers::pi / 6;

void check_consistent(const std::vector<double>& height, const std::vector<double>& radius, double area) {
  const BedState bed = measure_bed(height, radius, area);
  double solid = 0;
  for (double r : radius) solid += sphere_volume(r);
  REQUIRE(bed.height > 0);
  CHECK(bed.bulk_fraction * bed.height * area == Approx(solid));
  const double bulk = solid_volume_between(height, radius, bulk_lower * bed.height, bulk_upper * bed.height);
  CHECK(bulk / ((bulk_upper - bulk_lower) * area * bed.height) == Approx(bed.bulk_fraction).epsilon(1e-6));
}

}  // namespace

TEST_CASE("a cubic bed has its lattice's fraction and its own height") {
  const Snapshot s = cubic_bed(5, 5, 40);
  const auto packing = measured(s, "packing");
  CHECK(value(packing, "bulk_fraction") == Approx(cubic_fraction).epsilon(1e-3));
  CHECK(value(packing, "bed_height") == Approx(80).epsilon(1e-3));
  CHECK(value(packing, "cross_section") == Approx(100));
  CHECK(value(packing, "solid_volume") == Approx(1000 * sphere_volume(1 + 5e-7)));
  CHECK(packing.quantity("bulk_fraction")->uncertainty.value() < 0.01);
}

TEST_CASE("a bed of random points is found at its own height") {
  Random random(3, RandomStream::filling_position, 0);
  std::vector<double> height, radius(20000, 0.01);
  for (std::size_t i = 0; i < radius.size(); ++i) height.push_back(random.uniform(0, 5));
  const BedState bed = measure_bed(height, radius, 1.0);
  CHECK(bed.height == Approx(5).epsilon(0.02));
  check_consistent(height, radius, 1.0);
}

TEST_CASE("up follows gravity, and the floor its plane") {
  Snapshot s = cubic_bed(5, 5, 40);
  const double height = value(measured(s, "packing"), "bed_height");
  SECTION("upside down") {
    for (auto& p : s.position) p.z() = 80 - p.z();
    s.gravity = Vec3(0, 0, 9.8);
  }
  SECTION("along x") {
    for (auto& p : s.position) p = Vec3(p.z(), p.x(), p.y());
    s.domain.max = Vec3(80, 10, 10);
    s.domain.periodic = {false, true, true};
    s.gravity = Vec3(-9.8, 0.1, 0);
  }
  SECTION("a plane above the domain's face") {
    for (auto& p : s.position) p.z() += 17;
    s.domain.max.z() = 200;
    s.boundaries = {{"lid", "plane", Vec3(0, 0, 150), -Vec3::UnitZ()},
                    {"floor", "plane", Vec3(0, 0, 17), Vec3::UnitZ()}};
  }
  SECTION("no gravity: z") { s.gravity = Vec3::Zero(); }
  CHECK(value(measured(s, "packing"), "bed_height") == Approx(height).epsilon(1e-6));
}

TEST_CASE("a bed in a cylinder is measured over the cylinder's cross-section") {
  // The columns of a cubic bed that lie in a cylinder of radius 20, whose floor stands at 7.
  constexpr double radius = 20, floor = 7;
  Snapshot s = empty_box(Vec3(50, 50, 120), {false, false, false});
  const Vec3 middle(25, 25, 0);
  double columns = 0;
  for (int i = 0; i < 25; ++i) {
    for (int j = 0; j < 25; ++j) {
      const Vec3 column = Vec3(2 * i + 1, 2 * j + 1, 0);
      if ((column - middle).norm() > radius - 1) continue;
      ++columns;
      for (int k = 0; k < 40; ++k) add_particle(s, column + (floor + 2 * k + 1) * Vec3::UnitZ(), 1);
    }
  }
  BoundaryRecord drum{.name = "drum", .kind = "cylinder"};
  drum.point = middle + floor * Vec3::UnitZ();
  drum.normal = drum.axis = Vec3::UnitZ();
  drum.cross_section = std::numbers::pi * radius * radius;
  s.boundaries = {drum};
  const auto packing = measured(s, "packing");
  CHECK(value(packing, "cross_section") == Approx(1256.637061));
  CHECK(value(packing, "bed_height") == Approx(80).epsilon(1e-3));
  // Spheres of 4 pi / 3 at 2 a layer, over the circle.
  CHECK(value(packing, "bulk_fraction") == Approx(columns * 4 / (3 * radius * radius * 2)).epsilon(1e-3));
}

TEST_CASE("the cross-section is the smallest that stands upright, the floor the highest that looks up") {
  Snapshot s = empty_box(Vec3(3, 4, 10), {false, false, false});
  CHECK(bed_frame(s).area == Approx(12));
  BoundaryRecord pipe{.name = "pipe", .kind = "cylinder", .axis = -Vec3::UnitZ(), .cross_section = 5};
  BoundaryRecord lying = pipe, wide = pipe, open = pipe, tilted = pipe;
  lying.axis = Vec3::UnitX();
  lying.cross_section = 1;
  tilted.axis = Vec3(0.01, 0, 1).normalized();
  tilted.cross_section = 1;
  wide.cross_section = 20;
  open.cross_section = 0;
  s.boundaries = {lying, tilted, wide, open};
  CHECK(bed_frame(s).area == Approx(12));
  CHECK(bed_frame(s).floor == 0);  // none has a floor
  s.boundaries.push_back(pipe);
  CHECK(bed_frame(s).area == Approx(5));
  s.gravity = Vec3(9.8, 0, 0);
  CHECK(bed_frame(s).area == Approx(1));

  s.gravity = Vec3(0, 0, -9.8);
  s.boundaries = {{"floor", "plane", Vec3(0, 0, 1), Vec3::UnitZ()},
                  {"drum", "cylinder", Vec3(1, 1, 2), Vec3::UnitZ()},
                  {"lid", "box", Vec3(0, 0, 9), -Vec3::UnitZ()}};
  CHECK(bed_frame(s).floor == 2);
  s.gravity = -s.gravity;
  CHECK(bed_frame(s).floor == 9);
}

TEST_CASE("strange beds stay finite") {
  SECTION("one layer") { check_consistent(std::vector<double>(100, 1.0), std::vector<double>(100, 1.0), 400); }
  SECTION("one particle") { check_consistent({1.0}, {1.0}, 4); }
  SECTION("a falling cloud") { check_consistent({50, 52, 55, 58, 60}, {1, 1, 1, 1, 1}, 4); }
  SECTION("one particle far above the bed") {
    std::vector<double> height(1000), radius(1001, 1.0);
    for (std::size_t i = 0; i < height.size(); ++i) height[i] = 1 + 0.1 * static_cast<double>(i);
    height.push_back(1e9);
    check_consistent(height, radius, 100);
    CHECK(measure_bed(height, radius, 100).height == Approx(102).epsilon(0.05));
  }
  SECTION("no height satisfies the definition") {
    std::vector<double> height, radius(20, 1.0);
    for (int k = 0; k < 20; ++k) height.push_back(std::pow(10, k));
    const BedState bed = measure_bed(height, radius, 1);
    CHECK(std::isfinite(bed.height));
    CHECK(bed.bulk_fraction * bed.height == Approx(20 * sphere_volume(1)));
  }
  SECTION("nothing to measure") {
    const std::vector<double> one = {1.0}, zero = {0.0}, below = {-5.0};
    for (const BedState& bed :
         {measure_bed({}, {}, 1), measure_bed(one, one, 0), measure_bed(one, zero, 1), measure_bed(below, one, 1)}) {
      CHECK(bed.height == 0);
      CHECK(bed.bulk_fraction == 0);
    }
  }
}

TEST_CASE("the profile holds all solid, layer by layer") {
  const Snapshot s = cubic_bed(4, 4, 6);
  const auto packing = measured(s, "packing");
  const auto& profile = *packing.table("profile");
  REQUIRE(profile.rows.size() >= 12);  // layers of one radius
  double solid = 0;
  for (const auto& row : profile.rows) solid += row[2] * (row[1] - row[0]) * value(packing, "cross_section");
  CHECK(solid == Approx(value(packing, "solid_volume")).epsilon(1e-6));
  CHECK(profile.rows[0][2] == Approx(cubic_fraction).epsilon(1e-5));

  const auto thick = measured(s, "packing", {.profile_layer = 4.01});
  CHECK(thick.table("profile")->rows.size() == 3);
}

TEST_CASE("a particle far away does not fill the memory with layers") {
  Snapshot s = cubic_bed(4, 4, 6);
  add_particle(s, Vec3(1, 1, 1e12), 1);
  CHECK(measured(s, "packing").table("profile")->rows.size() <= 2001);
}

TEST_CASE("volume counted twice is the sum of the lenses") {
  Snapshot s = empty_box(Vec3(10, 10, 10), {false, false, false});
  add_particle(s, Vec3(5, 5, 1), 1);
  add_particle(s, Vec3(5, 5, 2), 1);
  // Two unit spheres at distance 1 share 5 pi / 12.
  CHECK(value(measured(s, "packing"), "overlap_share") == Approx(5.0 / 12 / (8.0 / 3)));
}

TEST_CASE("a domain without cross-section is refused") {
  Snapshot s = cubic_bed(2, 2, 2);
  s.domain.max.x() = s.domain.min.x();
  CHECK_THROWS_AS(measured(s, "packing"), InputError);
}
