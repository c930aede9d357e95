// Solid fractions of regions, of the interior, and by distance from the walls.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "analysis/packing/lens.hpp"
#include "analysis/packing/overlap_volume.hpp"
#include "core/error.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;

namespace {

using std::numbers::pi;

analysis::Options with_regions(const std::vector<std::string>& texts) {
  analysis::Options options;
  for (const auto& text : texts) options.regions.push_back(analysis::parse_region(text));
  return options;
}

/// Rows {region, volume, solid, fraction, particles, overlap_share}.
std::vector<std::vector<double>> region_rows(const Snapshot& s, const std::vector<std::string>& texts) {
  return measured(s, "packing", with_regions(texts)).table("regions")->rows;
}

/// A packing of spheres at random in a box of sides 10 with closed sides, gaps and overlaps as they come.
Snapshot random_spheres(std::array<bool, 3> periodic, std::size_t count = 300) {
  Snapshot s = empty_box(Vec3(10, 10, 10), periodic);
  Random random(7, RandomStream::filling_position, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double r = random.uniform(0.2, 0.9);
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = periodic[k] ? random.uniform(0, 10) : random.uniform(r, 10 - r);
    add_particle(s, p, r);
  }
  return s;
}

/// A cubic bed of unit spheres in a closed box, 20 x 20 and 40 high, gravity along an axis and direction.
Snapshot turned_bed(int axis, bool down) {
  Snapshot s = empty_box(Vec3(20, 20, 20), {false, false, false});
  s.domain.max[axis] = 60;
  s.gravity = (down ? -9.8 : 9.8) * Vec3::Unit(axis);
  for (int i = 0; i < 2000; ++i) {
    Vec3 p;
    p[(axis + 1) % 3] = 2 * (i % 10) + 1;
    p[(axis + 2) % 3] = 2 * (i / 10 % 10) + 1;
    p[axis] = 2 * (i / 100) + 1;
    if (!down) p[axis] = 60 - p[axis];
    add_particle(s, p, 1);
  }
  return s;
}

BoundaryRecord drum_about(const Vec3& centre, double radius) {
  BoundaryRecord drum{.name = "drum", .kind = "cylinder"};
  drum.point = centre;
  drum.normal = drum.axis = Vec3::UnitZ();
  drum.cross_section = pi * radius * radius;
  return drum;
}

/// Corners of a box, all that a boundary's place is read from.
BoundaryRecord block(const std::string& name, const Vec3& low, const Vec3& high) {
  return {.name = name, .kind = "mesh", .points = {low, high}};
}

/// Height of the interior of a bed in a box 20 wide: two diameters of 2 from the sides leave 12 x 12.
double interior_height(const Snapshot& s) { return value(measured(s, "packing"), "interior_volume") / 144; }

}  // namespace

TEST_CASE("lattices have their fraction in every box of whole cells") {
  struct Lattice {
    std::vector<Vec3> basis;
    double radius;
    Vec3 cell;
    double fraction;
  };
  const double h = std::sqrt(3), c = std::sqrt(8.0 / 3);
  const Vec3 cube = Vec3::Ones();
  const auto l = GENERATE_COPY(
      Lattice{simple_cubic, 0.5, cube, pi / 6}, Lattice{body_centred, std::sqrt(3) / 4, cube, std::sqrt(3) * pi / 8},
      Lattice{face_centred, std::sqrt(2) / 4, cube, std::sqrt(2) * pi / 6},
      Lattice{{Vec3(0, 0, 0), Vec3(0.5, h / 2, 0), Vec3(0.5, h / 6, c / 2), Vec3(0, 2 * h / 3, c / 2)},
              0.5,
              Vec3(1, h, c),
              std::sqrt(2) * pi / 6});
  Snapshot s = empty_box(4 * l.cell, {true, true, true});
  for (int k = 0; k < 64; ++k) {
    const Vec3 corner = l.cell.cwiseProduct(Vec3(k % 4, k / 4 % 4, k / 16));
    for (const Vec3& b : l.basis) add_particle(s, corner + b, l.radius);
  }
  // Anywhere, also across the periodic sides.
  const Vec3 low = Vec3(-0.73, 0.21, 1.9).cwiseProduct(l.cell), high = low + l.cell.cwiseProduct(Vec3(2, 1, 4));
  const auto rows =
      region_rows(s, {fmt::format("box:{},{},{},{},{},{}", low.x(), low.y(), low.z(), high.x(), high.y(), high.z()),
                      fmt::format("slab:y,{},{}", low.y(), low.y() + 2 * l.cell.y())});
  CHECK(rows[0][3] == Approx(l.fraction).epsilon(1e-13));
  CHECK(rows[1][3] == Approx(l.fraction).epsilon(1e-13));
  CHECK(rows[1][1] == Approx(l.cell.x() * l.cell.y() * l.cell.z() * 32).epsilon(1e-13));
  const auto packing = measured(s, "packing");
  CHECK(value(packing, "interior_fraction") == Approx(l.fraction).epsilon(1e-13));  // all of it: no walls, no surface
  CHECK(value(packing, "interior_volume") == Approx(s.domain.size().prod()).epsilon(1e-13));
}

TEST_CASE("parts of one sphere in regions of every kind") {
  Snapshot s = empty_box(Vec3(10, 10, 10), {true, false, false});
  add_particle(s, Vec3(0.1, 5, 5), 1);
  const auto rows = region_rows(
      s, {"box:-1, 4, 4, 1, 6, 6", "box:9.1,4,4,11.1,6,6", "slab:x,0,1", "sphere:0.1,5,6,1",
          "cylinder:x,5,5,0.1,9,20 cm", "ring:z,-0.4,5,0,10,500mm,2", "slab:z,7,8", "cylinder:y,0.1,5,-3,5,0.6"});
  const double whole = sphere_volume(1);
  CHECK(rows[0][2] ==
        Approx(whole - sphere_volume_below(1, -1 + 0.1) * 1).margin(1e-3));  // all but a cap below x = -0.9
  CHECK(rows[0][2] == Approx(whole - sphere_slab_volume(1, 0.1, 1, 2)).epsilon(1e-13));
  CHECK(rows[1][2] == Approx(whole).epsilon(1e-13));
  CHECK(rows[2][2] == Approx(sphere_slab_volume(1, 0.1, 0, 1)).epsilon(1e-13));
  CHECK(rows[3][2] == Approx(5 * pi / 12).epsilon(1e-13));
  CHECK(rows[4][2] == Approx(whole / 2 * (1 - std::pow(0.96, 1.5))).epsilon(1e-12));
  CHECK(rows[5][2] == Approx(whole - (2 * pi / 3 - 8.0 / 9)).epsilon(1e-12));  // Viviani's body is the hole
  CHECK(rows[5][1] == Approx(pi * (4 - 0.25) * 10).epsilon(1e-13));
  CHECK(rows[6][2] == 0);
  CHECK(std::isnan(rows[6][5]));
  CHECK(rows[7][1] == Approx(pi * 0.36 * 5).epsilon(1e-13));  // its lower end is the domain's
  CHECK(rows[7][2] == Approx(whole / 2 * (1 - 0.512)).epsilon(1e-12));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CHECK(rows[k][0] == static_cast<double>(k));
    CHECK(rows[k][3] == Approx(rows[k][2] / rows[k][1]));
    CHECK(rows[k][4] == (k == 6 ? 0 : 1));  // once, however many images
  }
}

TEST_CASE("regions that divide the domain share all solid") {
  const Snapshot s = random_spheres({true, true, false});
  double solid = 0;
  for (double r : s.radius) solid += sphere_volume(r);
  const auto slabs = region_rows(s, {"slab:x,-4,1.5", "slab:x,1.5,6", "slab:z,0,3", "slab:z,3,10"});
  CHECK(slabs[0][2] + slabs[1][2] == Approx(solid).epsilon(1e-12));
  CHECK(slabs[2][2] + slabs[3][2] == Approx(solid).epsilon(1e-12));
  const auto round = region_rows(s, {"cylinder:z,9,2,1,8,4", "cylinder:z,9,2,1,8,2.5", "ring:z,9,2,1,8,2.5,4"});
  CHECK(round[0][2] == Approx(round[1][2] + round[2][2]).epsilon(1e-11));
  CHECK(round[0][1] == Approx(round[1][1] + round[2][1]).epsilon(1e-14));
}

TEST_CASE("a region tells how much it counts twice") {
  Snapshot s = empty_box(Vec3(10, 10, 10), {true, false, false});
  add_particle(s, Vec3(9.5, 5, 5), 1);
  add_particle(s, Vec3(0.5, 5, 5), 1);
  // Two unit spheres at distance 1 share 5 pi / 12, across the periodic side.
  const auto rows = region_rows(s, {"box:-2,3,3,2,7,7", "slab:x,3,8.6"});
  CHECK(rows[0][5] == Approx(5.0 / 12 / (8.0 / 3)));
  CHECK(rows[0][4] == 2);
  CHECK(rows[1][5] == 0);
  CHECK(rows[1][4] == 1);
}

TEST_CASE("bad regions are refused in one clear line") {
  const auto bad = [](const std::string& text, const std::string& part) {
    CHECK_THROWS_WITH(analysis::parse_region(text), Contains(text) && Contains(part));
  };
  bad("ball:1,2,3,4", "sphere:x,y,z,radius");
  bad("sphere", "no such kind");
  bad("sphere:1,2,3", "3 values, but 4 are expected");
  bad("sphere:1,2,3,0", "radius must be above 0");
  bad("sphere:1,2,three,1", "not a number");
  bad("sphere:1,2,3 s,1", "wrong dimension");
  bad("box:0,0,0,1,0,1", "second corner");
  bad("slab:w,0,1", "expected x, y or z");
  bad("slab:z,1,1", "upper must be above lower");
  bad("cylinder:z,0,0,0,1,-1", "radius must be above 0");
  bad("ring:z,0,0,0,1,2,1", "outer must be above inner");
  bad("ring:z,0,0,0,1,-1,1", "0 or above");
  const auto refused = [](const std::string& text, const std::string& part) {
    CHECK_THROWS_WITH(region_rows(random_spheres({true, true, false}, 5), {text}), Contains(text) && Contains(part));
  };
  refused("slab:z,11,12", "outside of the domain");
  refused("slab:x,0,10.1", "longer than the periodic domain");
  refused("sphere:5,5,9,2", "round side");
  refused("cylinder:x,5,1,0,5,1.5", "round side");
  CHECK_THROWS_AS(measured(cubic_bed(2, 2, 2), "packing", {.interior_margin = -1}), InputError);
  CHECK_THROWS_AS(measured(cubic_bed(2, 2, 2), "packing", {.wall_layer = -1}), InputError);
  CHECK_THROWS_AS(measured(cubic_bed(2, 2, 2), "packing", {.map_cell = std::nan("")}), InputError);
}

TEST_CASE("the interior keeps clear of walls, floor and surface") {
  const int axis = GENERATE(0, 1, 2);
  const bool down = GENERATE(as<bool>{}, true, false);
  const Snapshot s = turned_bed(axis, down);
  const auto packing = measured(s, "packing");
  const double surface = std::min(40.0, value(packing, "bed_height"));
  CHECK(interior_height(s) == Approx(surface - 8).epsilon(1e-12));
  // 36 columns of spheres, whole ones from 4 on, the last cut.
  double solid = 0;
  for (int k = 2; k < 20; ++k) solid += 36 * sphere_slab_volume(1, 2 * k + 1, 4, surface - 4);
  CHECK(value(packing, "interior_fraction") == Approx(solid / (144 * (surface - 8))).epsilon(1e-12));
  CHECK(packing.quantity("interior_fraction")->uncertainty.value() < 0.02);
  const auto all = measured(s, "packing", {.interior_margin = 0});
  CHECK(value(all, "interior_volume") == Approx(400 * surface).epsilon(1e-12));
}

TEST_CASE("the interior's error is the blocks' standard error") {
  // Ten blocks of one diameter; the spheres of every second layer are missing.
  Snapshot s = empty_box(Vec3(4, 4, 20), {true, true, true});
  for (int k = 0; k < 10; k += 2) {
    for (int i = 0; i < 4; ++i) add_particle(s, Vec3(2 * (i % 2) + 1, 2 * (i / 2) + 1, 2 * k + 1), 1);
  }
  const auto packing = measured(s, "packing");
  CHECK(value(packing, "interior_fraction") == Approx(pi / 12).epsilon(1e-13));
  CHECK(packing.quantity("interior_fraction")->uncertainty.value() == Approx(pi / 12 / 3).epsilon(1e-12));
}

TEST_CASE("the interior is measured in volume-mean diameters") {
  Snapshot s = turned_bed(2, true);
  for (int k = 0; k < 100; ++k) add_particle(s, Vec3(10, 10, 20), 0.01);  // dust
  CHECK(value(measured(s, "packing"), "interior_volume") == Approx(144 * 32).epsilon(1e-3));
}

TEST_CASE("planes and boundaries push the interior away") {
  Snapshot s = turned_bed(2, true);
  const double before = interior_height(s);
  SECTION("a lid") {
    s.boundaries = {{"lid", "plane", Vec3(0, 0, 30), -Vec3::UnitZ()}};
    CHECK(interior_height(s) == Approx(30 - 8).epsilon(1e-12));
  }
  SECTION("a side plane") {
    s.boundaries = {{"side", "plane", Vec3(6, 0, 0), Vec3::UnitX()}};
    CHECK(interior_height(s) * 144 == Approx(before * 6 * 12).epsilon(1e-12));
  }
  SECTION("a tilted floor") {
    // z > x through the box, its normal 45 degrees off: highest above the column at x = 16, and a margin of 4.
    s.boundaries = {{"slope", "plane", Vec3(0, 0, 0), Vec3(-1, 0, 1).normalized()}};
    CHECK(interior_height(s) == Approx(before + 4 - 16 - 4 * std::sqrt(2)).epsilon(1e-12));
  }
  SECTION("a plane across a corner") {
    s.boundaries = {{"corner", "plane", Vec3(5, 5, 0), Vec3(1, 1, 0).normalized()}};
    const auto packing = measured(s, "packing");
    CHECK_FALSE(packing.quantity("interior_fraction")->value);
    CHECK_THAT(packing.quantity("interior_fraction")->note, Contains("corner"));
    s.boundaries[0].point = Vec3(1, 1, 0);
    CHECK(interior_height(s) == Approx(before));
  }
  SECTION("a body on the floor and one above") {
    s.boundaries = {block("foot", Vec3(8, 8, 0), Vec3(9, 9, 3))};
    CHECK(interior_height(s) == Approx(before - 3).epsilon(1e-12));
    s.boundaries = {block("stirrer", Vec3(8, 8, 30), Vec3(9, 9, 32))};
    CHECK(interior_height(s) == Approx(30 - 8).epsilon(1e-12));
    s.boundaries = {block("rod", Vec3(8, 8, 0), Vec3(9, 9, 60))};
    CHECK_THAT(measured(s, "packing").quantity("interior_fraction")->note, Contains("rod"));
  }
  SECTION("a box about all") {
    BoundaryRecord box = block("box", Vec3(0, 0, 0), Vec3(20, 20, 38));
    box.kind = "box";
    box.axis = Vec3::UnitZ();
    box.cross_section = 400;
    s.boundaries = {box};
    CHECK(interior_height(s) == Approx(38 - 8).epsilon(1e-12));
  }
  SECTION("a heap") {
    // Half of the bed ends at a height of 20.
    for (std::size_t i = s.size(); i-- > 0;) {
      if (s.position[i].x() < 10 && s.position[i].z() > 20) s.position[i].z() -= 20;
    }
    CHECK(interior_height(s) == Approx(20 - 8).epsilon(1e-12));
  }
}

TEST_CASE("the interior does not exist in a bed too narrow or too shallow") {
  for (const Snapshot& s : {cubic_bed(4, 4, 10, {false, false, false}), cubic_bed(20, 20, 3, {false, false, false})}) {
    const auto packing = measured(s, "packing");
    for (const char* key : {"interior_fraction", "interior_volume", "map_fraction_mean", "map_fraction_deviation"}) {
      CHECK_FALSE(packing.quantity(key)->value);
      CHECK_THAT(packing.quantity(key)->note, Contains("so far from"));
    }
  }
}

TEST_CASE("a cylinder's interior and rings") {
  Snapshot s = turned_bed(2, true);
  s.boundaries = {drum_about(Vec3(10, 10, 0), 10)};
  // Only what lies wholly inside.
  Snapshot inside = s;
  inside.position.clear(), inside.radius.clear(), inside.id.clear(), inside.type.clear(), inside.material.clear();
  for (const Vec3& p : s.position) {
    if (std::hypot(p.x() - 10, p.y() - 10) <= 9) add_particle(inside, p, 1);
  }
  const auto packing = measured(inside, "packing", {.wall_layer = 0.7});
  const double height = value(packing, "bed_height"), surface = std::min(40.0, height);
  CHECK(value(packing, "interior_volume") == Approx(pi * 36 * (surface - 8)).epsilon(1e-12));
  double solid = 0, rings = 0;
  for (const Vec3& p : inside.position) {
    const double d = std::hypot(p.x() - 10, p.y() - 10);
    solid += analysis::sphere_cylinder_volume(1, {d, 6, 4 - p.z(), surface - 4 - p.z()});
  }
  CHECK(value(packing, "interior_fraction") == Approx(solid / (pi * 36 * (surface - 8))).epsilon(1e-11));

  const auto& radial = packing.table("radial_profile")->rows;
  const auto& wall = packing.table("wall_profile")->rows;
  REQUIRE(radial.size() == 14);
  CHECK(radial.back()[1] == Approx(10));
  for (const auto& row : radial) rings += row[2] * pi * (row[1] * row[1] - row[0] * row[0]) * 0.7 * height;
  double bulk = 0;
  for (const Vec3& p : inside.position) bulk += sphere_slab_volume(1, p.z(), 0.1 * height, 0.8 * height);
  CHECK(rings == Approx(bulk).epsilon(1e-11));
  for (std::size_t k = 0; k < radial.size(); ++k) {
    CHECK(wall[k][2] == radial[radial.size() - 1 - k][2]);
    CHECK(wall[k][1] == Approx(10 - radial[radial.size() - 1 - k][0]));
  }
  SECTION("its place read from its surface") {
    BoundaryRecord& drum = inside.boundaries[0];
    drum.normal = Vec3::Zero();
    CHECK_THAT(measured(inside, "packing").quantity("interior_fraction")->note, Contains("does not tell where"));
    drum.points = {Vec3(0, 10, 0), Vec3(20, 10, 0), Vec3(10, 0, 50), Vec3(10, 20, 50)};
    CHECK(value(measured(inside, "packing"), "interior_volume") == Approx(value(packing, "interior_volume")));
  }
  SECTION("half out of the domain") {
    inside.boundaries[0].point.x() = 12;
    CHECK_THAT(measured(inside, "packing").quantity("interior_fraction")->note, Contains("out of the domain"));
  }
}

TEST_CASE("profiles from the walls of a box") {
  Snapshot s = random_spheres({false, true, false});
  const auto two_sides = measured(s, "packing", {.wall_layer = 0.5});
  CHECK(two_sides.table("radial_profile")->rows.empty());
  CHECK_THAT(two_sides.table("radial_profile")->caption, Contains("not applicable: a side is periodic"));
  const double height = value(two_sides, "bed_height"), lower = 0.1 * height, upper = 0.8 * height;
  const auto& wall = two_sides.table("wall_profile")->rows;
  REQUIRE(wall.size() == 10);
  for (const auto& row : wall) {  // two slabs, the same distance from either wall
    double solid = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (double x : {s.position[i].x(), 10 - s.position[i].x()}) {
        const Vec3 centre(x, 0, s.position[i].z());
        solid += analysis::sphere_box_volume(centre, s.radius[i], Vec3(row[0], -5, lower), Vec3(row[1], 5, upper));
      }
    }
    CHECK(row[2] == Approx(solid / (2 * 0.5 * 10 * (upper - lower))).epsilon(1e-11));
  }

  s.domain.periodic = {false, false, false};
  for (std::size_t i = 0; i < s.size(); ++i)
    s.position[i].y() = std::clamp(s.position[i].y(), s.radius[i], 10 - s.radius[i]);
  const auto closed = measured(s, "packing", {.wall_layer = 0.5});
  double shells = 0, inner = 0, bulk = 0;
  for (const auto& row : closed.table("wall_profile")->rows) {
    const double area = std::pow(10 - 2 * row[0], 2) - std::pow(10 - 2 * row[1], 2);
    shells += row[2] * area * (upper - lower);
  }
  for (std::size_t i = 0; i < s.size(); ++i) bulk += sphere_slab_volume(s.radius[i], s.position[i].z(), lower, upper);
  CHECK(shells == Approx(bulk).epsilon(1e-11));
  const auto& rings = closed.table("radial_profile")->rows;
  REQUIRE(rings.size() == 10);
  CHECK(rings.back()[1] == Approx(5));
  for (std::size_t k = 0; k < 4; ++k) inner += rings[k][2] * pi * (2 * static_cast<double>(k) + 1) * 0.25;
  const std::string core = fmt::format("cylinder:z,5,5,{},{},2", lower, upper);
  CHECK(inner * (upper - lower) == Approx(region_rows(s, {core})[0][2]).epsilon(1e-10));

  s.domain.periodic = {true, true, false};
  CHECK_THAT(measured(s, "packing").table("wall_profile")->caption, Contains("there are no side walls"));
}
