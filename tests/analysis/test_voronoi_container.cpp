// What bounds the Voronoi cells of measure "voronoi": boundaries, the bed's surface; and particles that have none.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/voronoi_fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;

namespace {

Snapshot random_cube() {
  Snapshot s = empty_box(Vec3(12, 12, 12), {false, false, false});
  fill_at_random(s, 2500, 0.3, 3);
  return s;
}

}  // namespace

TEST_CASE("planes cut the cells exactly") {
  Snapshot frame = empty_box(Vec3(12, 12, 12), {false, false, false});
  frame.boundaries = {{"floor", "plane", Vec3(0, 0, 2), Vec3::UnitZ()},
                      {"slope", "plane", Vec3(8, 0, 0), Vec3(1, 0, 1).normalized()}};
  const Snapshot s = taken_from(random_cube(), frame, [](const Vec3& p) { return p.z() > 2 && p.x() + p.z() > 8; });
  check_filled(voronoi(s), 12 * (12 * 10 - 6 * 6 / 2.0));
}

TEST_CASE("a box boundary cuts the cells, and ends periodic sides that it crosses") {
  Snapshot frame = empty_box(Vec3(12, 12, 12), {true, true, false});
  frame.boundaries = {box_record(Vec3(1, 2, 3), Vec3(10, 11, 9))};
  const Snapshot s = taken_from(random_cube(), frame, [](const Vec3& p) {
    return p.x() > 1 && p.x() < 10 && p.y() > 2 && p.y() < 11 && p.z() > 3 && p.z() < 9;
  });
  const auto result = voronoi(s);
  check_filled(result, 9 * 9 * 6);
  CHECK(result.quantity("container_volume")->note.empty());
}

TEST_CASE("a cylinder cuts the cells") {
  Snapshot frame = empty_box(Vec3(12, 12, 12), {true, false, false});
  frame.boundaries = {cylinder_record(Vec3(6, 6, 1), 5, 20)};
  SECTION("volumes sum up") {
    const auto in_can = [](const Vec3& p) { return std::hypot(p.x() - 6, p.y() - 6) < 5 && p.z() > 1; };
    check_filled(voronoi(taken_from(random_cube(), frame, in_can)), pi * 25 * 11);
  }
  SECTION("sectors around the axis") {
    constexpr int sectors = 5;
    for (int k = 0; k < sectors; ++k) {
      const double angle = 2 * pi * (k + 0.3) / sectors;
      add_particle(frame, Vec3(6 + 4 * std::cos(angle), 6 + 4 * std::sin(angle), 6), 1);
    }
    const auto result = voronoi(frame);
    const double volume = value(result, "container_volume");
    // A facet more or less falls to a sector: width over circumference.
    for (double v : column(result, volume_column)) CHECK(v == Approx(volume / sectors).epsilon(sectors / 96.0));
    CHECK(std::abs(value(result, "volume_error")) < 1e-12);
  }
  SECTION("of any axis") {
    frame = empty_box(Vec3(12, 12, 12), {false, false, false});
    frame.boundaries = {cylinder_record(Vec3(6, 6, -2), 5, 16)};
    for (Vec3& p : frame.boundaries[0].points) p = Vec3(p.z(), p.x(), p.y());
    frame.boundaries[0].axis = Vec3::UnitX();
    frame.boundaries[0].point = Vec3(-2, 6, 6);
    frame.boundaries[0].normal = Vec3::UnitX();
    const auto lying = [](const Vec3& p) { return std::hypot(p.y() - 6, p.z() - 6) < 5; };
    check_filled(voronoi(taken_from(random_cube(), frame, lying)), pi * 25 * 12);
  }
}

TEST_CASE("boundaries that do not hold the packing are left out, and named") {
  Snapshot s = random_cube();
  s.boundaries = {cylinder_record(Vec3(6, 6, 0), 3, 12), {"tank", "cone"}, {"gone", "box"}};
  SECTION("particles on both sides") {}
  SECTION("particles outside of a cylinder") {
    s.boundaries[0] = cylinder_record(Vec3(6, 6, 0), 20, 12);
    for (auto& triangle : s.boundaries[0].triangles) std::swap(triangle[1], triangle[2]);
  }
  SECTION("a wall with two sides") {
    s.boundaries[0] = cylinder_record(Vec3(6, 6, 0), 20, 12);
    s.boundaries[0].one_sided = false;
  }
  s.boundaries[1].normal = Vec3::UnitZ();  // the cone's floor, of which nothing is known beside
  const auto result = voronoi(s);
  check_filled(result, 12 * 12 * 12);
  for (const char* key : {"container_volume", "local_fraction_mean"}) {
    CHECK(result.quantity(key)->note == "cells are not cut by can (cylinder), tank (cone)");
  }
}

TEST_CASE("cells at the open surface are left out") {
  SECTION("a flat bed below open space") {
    Snapshot s = cubic_bed(6, 6, 5);
    s.domain.max.z() = 100;
    const auto result = voronoi(s);
    CHECK(value(result, "surface_cells") == 36);
    CHECK(value(result, "local_fraction_mean") == Approx(pi / 6).epsilon(1e-5));  // overlaps of 5e-7
    CHECK(value(result, "container_volume") < 12 * 12 * (10 + 4 + 1.2 + 0.1));
  }
  SECTION("with gravity upwards") {
    Snapshot s = cubic_bed(6, 6, 5);
    s.domain.min.z() = -100;
    s.gravity = -s.gravity;
    const auto result = voronoi(s);
    CHECK(value(result, "surface_cells") == 36);
    CHECK(value(result, "local_fraction_mean") == Approx(pi / 6).epsilon(1e-5));
  }
  SECTION("a heap") {
    // A stepped pyramid: whole cells are cubes, all others reach open space.
    Snapshot s = empty_box(Vec3(100, 100, 100), {false, false, false});
    std::size_t buried = 0;
    for (int layer = 0; layer < 5; ++layer) {
      for (int x = layer; x < 15 - layer; ++x) {
        for (int y = layer; y < 15 - layer; ++y) {
          add_particle(s, Vec3(40 + 2 * x, 40 + 2 * y, 1 + 2 * layer), 1);
          const bool below_next = x > layer && x < 14 - layer && y > layer && y < 14 - layer;
          buried += layer < 4 && below_next;
        }
      }
    }
    const auto result = voronoi(s);
    std::size_t whole = 0;
    for (const auto& row : result.table("cells")->rows) {
      if (row[state_column] != 0) continue;
      ++whole;
      CHECK(row[volume_column] == Approx(8).epsilon(1e-9));
    }
    CHECK(whole == buried);
  }
  SECTION("under a lid that touches the bed nothing is open") {
    Snapshot s = cubic_bed(6, 6, 5);
    s.domain.max.z() = 100;
    s.boundaries = {{"lid", "plane", Vec3(0, 0, 10), -Vec3::UnitZ()}};
    const auto result = voronoi(s);
    CHECK(value(result, "surface_cells") == 0);
    check_filled(result, 12 * 12 * 10);
  }
}

TEST_CASE("particles without cell are counted") {
  Snapshot s = empty_box(Vec3(4, 4, 4), {false, false, false});
  add_particle(s, Vec3(2, 2, 2), 1, 1);
  SECTION("covered by a larger one") { add_particle(s, Vec3(2.2, 2, 2), 0.1); }
  SECTION("at the same place, smaller") { add_particle(s, Vec3(2, 2, 2), 0.9); }
  SECTION("at the same place, equal") { add_particle(s, Vec3(2, 2, 2), 1); }
  SECTION("nearer than round-off can tell") { add_particle(s, Vec3(2 + 1e-12, 2, 2 - 1e-13), 1); }
  SECTION("at the same place across a periodic side") {
    s.domain.periodic = {true, false, false};
    s.position[0].x() = 4 - 1e-13;
    add_particle(s, Vec3(1e-13, 2, 2), 1);
  }
  const auto result = voronoi(s);
  check_filled(result, 64);
  CHECK(value(result, "lost_cells") == 1);
  CHECK(value(result, "cells") == 1);
  CHECK(column(result, state_column)[1] == 2);
  CHECK(result.table("types")->rows[0][1] == 0);
}

TEST_CASE("many particles at one place leave one cell") {
  Snapshot s = empty_box(Vec3(4, 4, 4), {true, true, true});
  for (int i = 0; i < 20; ++i) add_particle(s, Vec3(1, 3, 2), i == 7 ? 0.6 : 0.5);
  const auto result = voronoi(s);
  check_filled(result, 64);
  CHECK(value(result, "lost_cells") == 19);
  CHECK(column(result, state_column)[7] == 0);
  CHECK(value(result, "local_fraction_mean") == Approx(sphere_volume(0.6) / 64).epsilon(1e-12));
}

TEST_CASE("particles outside the container take no part") {
  Snapshot s = cubic_bed(6, 6, 5);
  s.domain.max.z() = 10;
  add_particle(s, Vec3(5, 5, -1), 1);
  add_particle(s, Vec3(5, 5, 11), 1);
  const auto result = voronoi(s);
  check_filled(result, 12 * 12 * 10);
  CHECK(value(result, "outside_particles") == 2);
  CHECK(value(result, "cells") == 180);
}

TEST_CASE("centres on the container's sides have cells") {
  Snapshot s = empty_box(Vec3(4, 4, 4), {true, false, false});
  add_particle(s, Vec3(4, 4, 4), 1);
  add_particle(s, Vec3(2, 0, 0), 1);
  const auto result = voronoi(s);
  check_filled(result, 64);
  CHECK(column(result, volume_column)[0] == Approx(32).epsilon(1e-10));
}

TEST_CASE("spheres of radius 0 have ordinary Voronoi cells") {
  Snapshot s = lattice(face_centred, 3, 3, 3, 1.0, 0.0);
  const auto result = voronoi(s);
  check_filled(result, 27);
  for (double v : column(result, volume_column)) CHECK(v == Approx(0.25).epsilon(1e-12));
  CHECK(value(result, "local_fraction_mean") == 0);
  CHECK(result.quantity("reduced_volume_mean")->note == "some radii are 0");
  CHECK(result.quantity("gamma_shape")->note == "all radii are 0");
}

TEST_CASE("without cells the reason is given") {
  const auto reason = [](const Snapshot& s) { return voronoi(s).quantity("local_fraction_mean")->note; };
  Snapshot s = empty_box(Vec3(10, 10, 10));
  CHECK(reason(s) == "no particles");
  add_particle(s, Vec3(5, 5, 1), 1);
  CHECK(reason(s) == "every cell is at the surface");
  s.position[0].z() = -50;
  CHECK(reason(s) == "the container holds no particle");
}

TEST_CASE("a crowd far from a stray particle is refused rather than taking hours") {
  Snapshot s = empty_box(Vec3(1e6, 1e6, 1e6), {false, false, false});
  fill_at_random(s, 5000, 0.5, 9);
  for (auto& p : s.position) p *= 1e-5;
  add_particle(s, Vec3(9e5, 9e5, 9e5), 1);
  CHECK_THROWS_AS(voronoi(s), InputError);
  CHECK_THROWS_WITH(voronoi(s), Contains("particles crowd in one of"));
}

TEST_CASE("cells are listed on request alone") {
  const Snapshot s = cubic_bed(3, 3, 3);
  CHECK(measured(s, "voronoi").table("cells") == nullptr);
  REQUIRE(voronoi(s).table("cells") != nullptr);
  for (const auto& result : analysis::analyze(s)) CHECK(result.name != "voronoi");
}
