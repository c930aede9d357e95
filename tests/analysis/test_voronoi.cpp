// Radical Voronoi cells against closed forms, and that they fill what they should.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <omp.h>

#include "analysis/writers.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/voronoi_fixtures.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::fixtures;

TEST_CASE("cells of lattices have their volumes and faces") {
  struct Case {
    std::vector<Vec3> basis;
    double volume;  // edge 1
    int faces;
  };
  const auto c = GENERATE(Case{simple_cubic, 1, 6}, Case{body_centred, 0.5, 14}, Case{face_centred, 0.25, 12});
  const double edge = 3e-6;  // metres, as of a powder
  const auto result = voronoi(lattice(c.basis, 4, 5, 6, edge, 0.3 * edge));
  check_filled(result, 4 * 5 * 6 * edge * edge * edge);
  const double cell = c.volume * edge * edge * edge, sphere = sphere_volume(0.3 * edge);
  for (double v : column(result, volume_column)) CHECK(v == Approx(cell).epsilon(1e-12));
  for (double f : column(result, faces_column)) CHECK(f == c.faces);
  CHECK(value(result, "surface_cells") == 0);
  CHECK(value(result, "local_fraction_mean") == Approx(sphere / cell).epsilon(1e-12));
  CHECK(value(result, "local_fraction_mean_by_volume") == Approx(sphere / cell).epsilon(1e-12));
  CHECK(value(result, "reduced_volume_mean") == Approx(cell / sphere).epsilon(1e-12));
  CHECK(value(result, "faces_mean") == c.faces);
  CHECK(value(result, "local_fraction_deviation") == Approx(0).margin(1e-12));
  CHECK(value(result, "faces_deviation") == 0);
}

TEST_CASE("touching spheres on a lattice fill walls that touch them") {
  // The fraction is that of the cubes around the spheres: walls, floor and the domain's top at the spheres' top.
  const Snapshot s = lattice(simple_cubic, 5, 5, 5, 2.0, 1.0, {false, false, false});
  const auto result = voronoi(s);
  check_filled(result, 1000);
  for (double v : column(result, volume_column)) CHECK(v == Approx(8).epsilon(1e-12));
  CHECK(value(result, "local_fraction_mean") == Approx(pi / 6).epsilon(1e-12));
  CHECK(value(result, "surface_cells") == 0);
}

TEST_CASE("a radical lattice of two sizes has cells in closed form") {
  // Caesium chloride, edge 1: planes across <111> at t = (d^2 + r1^2 - r2^2) / (2 d), d = sqrt(3) / 2, cut the eight
  // corners of the cube around a sphere; in an octant |x| + |y| + |z| > sqrt(3) t is cut off.
  const double r1 = 0.45, r2 = 0.3;
  Snapshot s = lattice(body_centred, 4, 4, 4, 1.0, r1);
  for (std::size_t i = 1; i < s.size(); i += 2) {
    s.radius[i] = r2;
    s.type[i] = 1;
  }
  const auto cell = [](double own, double other) {
    const double d = std::sqrt(3.0) / 2, t = (d * d + own * own - other * other) / (2 * d);
    const double corner = std::max(0.0, 1.5 - std::sqrt(3.0) * t), beyond = std::max(0.0, corner - 0.5);
    return 1 - 8 * (std::pow(corner, 3) - 3 * std::pow(beyond, 3)) / 6;
  };
  REQUIRE(cell(r1, r2) + cell(r2, r1) == Approx(1).epsilon(1e-14));
  const auto result = voronoi(s);
  const auto volume = column(result, volume_column);
  for (std::size_t i = 0; i < s.size(); ++i) {
    CHECK(volume[i] == Approx(i % 2 ? cell(r2, r1) : cell(r1, r2)).epsilon(1e-11));
  }
  const auto& types = result.table("types")->rows;
  REQUIRE(types.size() == 2);
  CHECK(types[0][1] == 64);
  CHECK(types[0][2] == Approx(sphere_volume(r1) / cell(r1, r2)).epsilon(1e-11));
  CHECK(types[1][2] == Approx(sphere_volume(r2) / cell(r2, r1)).epsilon(1e-11));
  const double f1 = types[0][2], f2 = types[1][2], v1 = cell(r1, r2), v2 = cell(r2, r1);
  const double by_volume = sphere_volume(r1) + sphere_volume(r2);
  CHECK(value(result, "local_fraction_mean") == Approx((f1 + f2) / 2).epsilon(1e-11));
  CHECK(value(result, "local_fraction_deviation") == Approx((f1 - f2) / 2 * std::sqrt(128 / 127.0)).epsilon(1e-11));
  CHECK(value(result, "local_fraction_mean_by_volume") == Approx(by_volume).epsilon(1e-11));
  CHECK(value(result, "local_fraction_deviation_by_volume") ==
        Approx(std::sqrt(v1 * std::pow(f1 - by_volume, 2) + v2 * std::pow(f2 - by_volume, 2))).epsilon(1e-11));
  CHECK(value(result, "reduced_volume_mean") == Approx((1 / f1 + 1 / f2) / 2).epsilon(1e-11));
  CHECK_FALSE(result.quantity("gamma_shape")->value);

  const auto& bins = result.table("local_fraction_distribution")->rows;
  double density = 0, share = 0;
  for (const auto& row : bins) {
    density += row[3] * (row[1] - row[0]);
    share += row[4];
  }
  CHECK(density == Approx(1));
  CHECK(share == Approx(1));
  CHECK((bins.front()[0] <= std::min(f1, f2) && bins.back()[1] > std::max(f1, f2)));
}

TEST_CASE("the radical plane divides a box between two spheres") {
  Snapshot s = empty_box(Vec3(5, 3, 2), {false, false, false});
  const double r1 = 1.0, r2 = 0.4;
  add_particle(s, Vec3(1.2, 1.5, 1), r1);
  add_particle(s, Vec3(4, 1.5, 1), r2);
  const double d = 2.8, plane = 1.2 + (d * d + r1 * r1 - r2 * r2) / (2 * d);
  const auto result = voronoi(s);
  const auto volume = column(result, volume_column);
  CHECK(volume[0] == Approx(6 * plane).epsilon(1e-13));
  CHECK(volume[1] == Approx(6 * (5 - plane)).epsilon(1e-13));
  CHECK(column(result, faces_column) == std::vector<double>{6, 6});
}

TEST_CASE("a sphere's own images bound its cell") {
  Snapshot s = empty_box(Vec3(4, 3, 5), {true, true, true});
  add_particle(s, Vec3(0.1, 2.9, 1), 1);
  const auto result = voronoi(s);
  check_filled(result, 60);
  CHECK(value(result, "local_fraction_mean") == Approx(sphere_volume(1) / 60).epsilon(1e-13));
  CHECK_FALSE(result.quantity("local_fraction_deviation")->value);
}

TEST_CASE("cells fill any box, of every size ratio") {
  const auto periodic = GENERATE(std::array<bool, 3>{true, true, true}, std::array<bool, 3>{false, true, false},
                                 std::array<bool, 3>{false, false, false});
  const double smallest = GENERATE(1.0, 0.5, 0.05);
  Snapshot s = empty_box(Vec3(14, 9, 11), periodic);
  s.domain.min = Vec3(-3, 2, 1);
  s.domain.max += s.domain.min;
  fill_at_random(s, 800, smallest, 7);
  check_filled(voronoi(s), 14 * 9 * 11);
}

TEST_CASE("the cells are those of the program voro++") {
  if (std::system("command -v voro++ > /dev/null") != 0) FAIL("the program voro++ is not installed (setup.sh test)");
  Snapshot s = empty_box(Vec3(16, 13, 11), {true, false, false});
  fill_at_random(s, 3000, 0.1, 5);
  const testing::TemporaryFolder folder;
  const auto packing = folder / "packing";
  std::ofstream file(packing);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3& p = s.position[i];
    file << fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g}\n", i, p.x(), p.y(), p.z(), s.radius[i]);
  }
  file.close();
  const std::string command = "voro++ -r -px -c '%i %v %s' 0 16 0 13 0 11 " + packing.string() + " > /dev/null";
  REQUIRE(std::system(command.c_str()) == 0);

  const auto result = voronoi(s);
  const auto volume = column(result, volume_column), faces = column(result, faces_column);
  std::ifstream output(packing.string() + ".vol");
  std::size_t row, cells = 0;
  double program_volume, program_faces;
  while (output >> row >> program_volume >> program_faces) {
    ++cells;
    INFO("particle " << row);
    CHECK(volume[row] == Approx(program_volume).epsilon(1e-5));  // it prints six digits
    CHECK(faces[row] == program_faces);
  }
  CHECK(static_cast<double>(cells) == value(result, "cells"));
  CHECK(value(result, "lost_cells") > 0);
  CHECK(value(result, "cells") + value(result, "lost_cells") == 3000);
}

TEST_CASE("cells are the same bits for any number of threads") {
  Snapshot packing = empty_box(Vec3(14, 14, 14)), frame = packing;
  fill_at_random(packing, 3000, 0.2, 6);
  frame.boundaries = {cylinder_record(Vec3(7, 7, 0), 7, 14)};
  const Snapshot s = taken_from(packing, frame, [](const Vec3& p) { return std::hypot(p.x() - 7, p.y() - 7) < 7; });
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = analysis::to_json(std::vector{voronoi(s)});
  omp_set_num_threads(3);
  const auto three = analysis::to_json(std::vector{voronoi(s)});
  omp_set_num_threads(before);
  CHECK(one == three);
}

TEST_CASE("the gamma distribution's shape follows from mean and variance of equal spheres' cells") {
  Snapshot s = lattice(simple_cubic, 6, 6, 6, 2.5, 0.9);
  for (std::size_t i = 0; i < s.size(); ++i) {
    Random random(8, RandomStream::filling_position, i);
    for (int k = 0; k < 3; ++k) s.position[i][k] += random.uniform(-0.3, 0.3);
  }
  const auto result = voronoi(s);
  double sum = 0, squares = 0;
  for (double v : column(result, volume_column)) {
    sum += v;
    squares += v * v;
  }
  const double n = 216, mean = sum / n, variance = (squares - n * mean * mean) / (n - 1);
  const double dodecahedron = 10 * std::sqrt(130 - 58 * std::sqrt(5.0)) * std::pow(0.9, 3);  // inscribed radius 0.9
  CHECK(value(result, "gamma_shape") == Approx(std::pow(mean - dodecahedron, 2) / variance).epsilon(1e-5));
}
