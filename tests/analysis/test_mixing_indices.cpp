// Mixing indices of layers, rings, cells and contacts where they are known exactly, and where there are none.
#include <cmath>
#include <map>

#include <catch2/catch.hpp>
#include <omp.h>

#include "core/error.hpp"
#include "tests/analysis/mixed_beds.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

TEST_CASE("a checkerboard is mixed evenly in cells of two by two by two") {
  Snapshot s = closed_bed(8, 8, 8);
  label(s, [](int x, int y, int z) { return (x + y + z) % 2; });
  const auto result = indices_of(s);
  for (const std::string part : {"", "cell_"}) {
    INFO(part);
    CHECK(value(result, part + "intensity") == Approx(0).margin(1e-12));
    CHECK(value(result, part + "rsd") == Approx(0).margin(1e-6));
    CHECK(value(result, part + "entropy") == Approx(1).epsilon(1e-12));
    CHECK(value(result, part + "entropy") > *result.quantity(part + "entropy_random_high")->value);
    CHECK(value(result, part + "intensity") < *result.quantity(part + "intensity_random_low")->value);
  }
  // Cells of n = 8 of N = 512: s0^2 / (s0^2 - sr^2) with sr^2 = s0^2 / n (N - n) / (N - 1).
  const double random = 1.0 / 8 * (512.0 - 8) / 511;
  CHECK(value(result, "cell_lacey") == Approx(1 / (1 - random)).epsilon(1e-9));
  CHECK(value(result, "centre_distance") == Approx(0).margin(1e-9));
  // Every contact joins unlike particles: one over 1 - 2 * 256 * 255 / (512 * 511).
  CHECK(value(result, "contact_mixing") == Approx(511.0 / 256).epsilon(1e-12));
}

TEST_CASE("separated halves: every index at its limit") {
  Snapshot s = closed_bed(8, 8, 8);
  label(s, [](int, int, int z) { return z < 4 ? 1 : 0; });
  const auto result = indices_of(s);
  CHECK(value(result, "cell_lacey") == Approx(0).margin(1e-12));
  CHECK(value(result, "cell_intensity") == Approx(1).epsilon(1e-12));
  CHECK(value(result, "cell_entropy") == Approx(0).margin(1e-12));
  CHECK(value(result, "cell_rsd") == Approx(value(result, "rsd_separated")).epsilon(1e-12));
  CHECK(value(result, "rsd_separated") == Approx(1));
  CHECK(value(result, "rsd") == Approx(1).epsilon(1e-4));
  CHECK(value(result, "entropy") == Approx(0).margin(1e-4));
  CHECK(value(result, "height_difference_separated") == Approx(0.5));
  CHECK(value(result, "centre_distance") == Approx(8).epsilon(1e-9));
  CHECK(value(result, "centre_distance_separated") ==
        Approx(8 * std::sqrt(64.0 / 64) * std::sqrt(512.0 / 511) * std::sqrt(1 - 1.0 / 64)).epsilon(1e-9));
  // Only the 64 contacts across the middle of 3 * 7 * 64 join unlike particles.
  CHECK(value(result, "contact_mixing") == Approx(64.0 / 1344 * 511 / 256).epsilon(1e-12));
  CHECK(value(result, "contact_mixing_z") < -20);
  CHECK(value(result, "centre_distance_z") > 20);
  // Rings about the upright axis hold as much of both.
  CHECK(value(result, "ring_intensity") == Approx(0).margin(1e-12));
}

TEST_CASE("separated about the axis: rings tell, layers do not") {
  Snapshot s = closed_bed(10, 10, 6);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double x = s.position[i].x() - 10, y = s.position[i].y() - 10;
    s.type[i] = x * x + y * y < 81.0 ? 1 : 0;  // half the area of the circle through the corners
  }
  const auto result = indices_of(s, {.segregation_rings = 2});
  CHECK(value(result, "ring_intensity") == Approx(1).epsilon(1e-12));
  CHECK(value(result, "ring_lacey") == Approx(0).margin(1e-12));
  CHECK(value(result, "ring_entropy") == Approx(0).margin(1e-12));
  CHECK(value(result, "intensity") == Approx(0).margin(1e-9));
  const auto& rows = result.table("rings")->rows;
  REQUIRE(rows.size() == 4);
  CHECK(rows[0][1] == Approx(9).epsilon(1e-12));  // centres reach sqrt(162)
  CHECK(rows[2][1] == Approx(std::sqrt(162)).epsilon(1e-12));
  // About x the same bed is not separated.
  CHECK(value(indices_of(s, {.segregation_rings = 2, .segregation_axis = AlongAxis::x}), "ring_intensity") < 0.5);
}

TEST_CASE("rings lie about the boundary that encloses the bed") {
  Snapshot s = empty_box(Vec3(100, 100, 10), {false, false, false});
  BoundaryRecord wall{.name = "wall", .kind = "cylinder"};
  wall.axis = Vec3::UnitZ();
  wall.cross_section = 300;
  wall.points = {Vec3(20, 30, 0), Vec3(40, 30, 0), Vec3(30, 20, 10), Vec3(30, 40, 10)};
  s.boundaries.push_back(wall);
  for (int k = 0; k < 8; ++k) {  // one type at distance 2 from the axis, the other at 8
    const double angle = k;
    const double distance = k % 2 ? 2 : 8;
    add_particle(s, Vec3(30 + distance * std::cos(angle), 30 + distance * std::sin(angle), 1 + k), 0.5, k % 2);
  }
  const auto result = indices_of(s, {.segregation_rings = 4});
  CHECK(value(result, "ring_intensity") == Approx(1).epsilon(1e-12));
  CHECK(result.table("rings")->rows.back()[1] == Approx(8).epsilon(1e-12));
}

TEST_CASE("layers along another axis") {
  Snapshot s = closed_bed(8, 6, 6);
  label(s, [](int x, int, int) { return x < 4 ? 1 : 0; });
  CHECK(value(indices_of(s), "intensity") == Approx(0).margin(1e-9));
  const auto along_x = indices_of(s, {.segregation_axis = AlongAxis::x});
  CHECK(value(along_x, "intensity") == Approx(1).epsilon(1e-4));
  CHECK(value(along_x, "lacey") == Approx(0).margin(1e-4));
  CHECK(value(along_x, "height_difference") == Approx(0).margin(1e-9));  // stays along up
  CHECK(value(indices_of(s, {.segregation_axis = AlongAxis::z}), "lacey") == value(indices_of(s), "lacey"));
}

TEST_CASE("shares by number, volume and mass are those by hand") {
  // Two cells: one light and three heavy on the left, two light on the right; light spheres twice as large.
  Snapshot s = empty_box(Vec3(12, 4, 4), {false, false, false});
  add_particle(s, Vec3(2, 2, 1), 1, 0);
  for (int k = 0; k < 3; ++k) add_particle(s, Vec3(1 + k, 1, 3), 0.5, 1);
  add_particle(s, Vec3(10, 2, 1), 1, 0);
  add_particle(s, Vec3(10, 2, 3), 1, 0);
  const auto intensity = [](double light, double heavy, double right) {  // amounts: left light, left heavy, right light
    const double left = light + heavy, all = left + right, p = heavy / all;
    return (left / all * std::pow(heavy / left - p, 2) + right / all * p * p) / (p * (1 - p));
  };
  const auto of = [&](ShareBy by) {
    return value(measured(s, "segregation", {.segregation_cell = 5, .segregation_by = by}), "cell_intensity");
  };
  CHECK(of(ShareBy::number) == Approx(intensity(1, 3, 2)).epsilon(1e-12));
  CHECK(of(ShareBy::volume) == Approx(intensity(8, 3, 16)).epsilon(1e-12));
  CHECK(of(ShareBy::mass) == Approx(intensity(8 * 1200, 3 * 7800, 16 * 1200)).epsilon(1e-12));
}

TEST_CASE("scale of scrutiny: finer structure than the cells is mixed, coarser separated") {
  Snapshot s = closed_bed(12, 12, 12);
  label(s, [](int x, int, int) { return x / 3 % 2; });  // slabs three particles thick
  const auto result = indices_of(s);
  const Table& table = *result.table("scale");
  std::map<std::string, std::size_t> column;
  for (std::size_t k = 0; k < table.columns.size(); ++k) column[table.columns[k].name] = k;
  REQUIRE(table.rows.size() >= 5);
  double previous = 0;
  int equal = 0;
  for (const auto& row : table.rows) {
    CHECK(row[column["edge"]] > previous);
    previous = row[column["edge"]];
    CHECK(row[column["cells"]] * row[column["particles"]] == Approx(1728));
    const double n = row[column["particles"]];
    const double along = std::cbrt(row[column["cells"]]);
    if (std::fmod(12, along) == 0) {  // equal cells, whose expectation is exact
      CHECK(std::abs(row[column["intensity_random"]] - (1728 - n) / (1727 * n)) <
            sigmas * row[column["intensity_deviation"]] / std::sqrt(200));
      ++equal;
    }
    CHECK(row[column["intensity_separated"]] <= Approx(1));
    CHECK(row[column["entropy_separated"]] < row[column["entropy_random"]]);
  }
  CHECK(table.rows.front()[column["edge"]] == Approx(3).epsilon(0.1));
  CHECK(equal >= 2);
  // Halves of the bed: two slabs each.
  const auto& coarse = table.rows.back();
  REQUIRE(coarse[column["cells"]] == 8);
  CHECK(coarse[column["intensity"]] == Approx(0).margin(1e-12));
  CHECK(coarse[column["entropy"]] == Approx(1));
  CHECK(coarse[column["intensity_separated"]] == Approx(1));
  CHECK(table.rows.front()[column["intensity"]] > 0.5);
}

TEST_CASE("the numbers do not depend on the threads") {
  Snapshot s = closed_bed(6, 6, 6);
  label_at_random(s, std::vector<int>{72, 144}, 9);
  SECTION("types change place") {}
  SECTION("particles change place") {
    for (std::size_t i = 0; i < s.size(); ++i) s.radius[i] = s.type[i] == 1 ? 1.0 : 0.8;
  }
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto alone = indices_of(s);
  omp_set_num_threads(4);
  const auto together = indices_of(s);
  omp_set_num_threads(threads);
  for (std::size_t k = 0; k < alone.quantities.size(); ++k) {
    CHECK(alone.quantities[k].value == together.quantities[k].value);
    CHECK(alone.quantities[k].uncertainty == together.quantities[k].uncertainty);
  }
  CHECK(alone.table("scale")->rows == together.table("scale")->rows);
}

TEST_CASE("a type of one particle") {
  Snapshot s = closed_bed(6, 6, 6);
  label(s, [](int x, int y, int z) { return x == 0 && y == 0 && z == 0 ? 1 : 0; });
  const auto result = indices_of(s);
  // One cell of 27 holds it: c = 1/8, P = 1/216.
  const double p = 1.0 / 216, variance = (std::pow(1.0 / 8 - p, 2) + 26 * p * p) / 27;
  CHECK(value(result, "cell_intensity") == Approx(variance / (p * (1 - p))).epsilon(1e-12));
  // Wherever it lies the cells' variance is the same: it cannot be told from random.
  CHECK(value(result, "cell_lacey") == Approx(1).epsilon(1e-12));
  CHECK_FALSE(result.quantity("cell_lacey_z")->value);
  CHECK(value(result, "rsd_separated") == Approx(std::sqrt(215)));
  CHECK(value(result, "contact_mixing") == Approx(3.0 / 540 * 108).epsilon(1e-12));
}

TEST_CASE("indices that do not exist say why, none is ever NaN") {
  Snapshot s = closed_bed(4, 4, 4);
  label(s, [](int x, int, int) { return x % 2; });
  Options options;
  std::vector<std::pair<std::string, std::string>> missing;
  SECTION("one type") {
    std::fill(s.type.begin(), s.type.end(), 0);
    missing = {{"cell_lacey", "one type"}, {"ring_rsd", "one type"}, {"contact_mixing", "one type"}};
  }
  SECTION("no particles") {
    s = empty_box(Vec3(1, 1, 1));
    missing = {{"cell_entropy", "no particles"}, {"centre_distance", "no particles"}};
  }
  SECTION("one particle") {
    s = empty_box(Vec3(4, 4, 4));
    add_particle(s, Vec3(1, 1, 1), 1);
    missing = {{"cell_entropy", "one type"}};
  }
  SECTION("all in one cell") {
    options.segregation_cell = 100;
    missing = {{"cell_lacey", "one cell"}, {"cell_rsd", "one cell"}};
  }
  SECTION("periodic across the axis") {
    s.domain.periodic = {true, true, false};
    missing = {{"ring_lacey", "periodic across"}};
  }
  SECTION("periodic everywhere") {
    s.domain.periodic = {true, true, true};
    missing = {{"centre_distance", "periodic along every"}, {"height_difference", "periodic along up"}};
  }
  SECTION("on the axis") {
    s = empty_box(Vec3(4, 4, 10), {false, false, false});
    for (int k = 0; k < 4; ++k) add_particle(s, Vec3(2, 2, 1 + 2 * k), 1, k % 2);
    missing = {{"ring_lacey", "on the axis"}, {"contact_mixing", "no contacts"}};
  }
  SECTION("no mass") {
    s.groups[1].density = 0;
    options.segregation_by = ShareBy::mass;
    missing = {{"cell_lacey", "no mass"}};
  }
  SECTION("no size, by number") {
    std::fill(s.radius.begin(), s.radius.end(), 0.0);
    options.segregation_by = ShareBy::number;
    missing = {{"cell_lacey", "no size"}, {"height_difference_separated", ""}, {"contact_mixing", "no contacts"}};
  }
  SECTION("only large particles touch") {
    for (std::size_t i = 0; i < s.size(); ++i) s.radius[i] = s.type[i] == 1 ? 1 + 5e-7 : 0.5;
    missing = {{"contact_mixing", "one type touch"}};
  }
  const auto result = measured(s, "segregation", options);
  for (const auto& [key, reason] : missing) {
    INFO(key);
    REQUIRE(result.quantity(key));
    CHECK_FALSE(result.quantity(key)->value);
    CHECK(result.quantity(key)->note.find(reason) != std::string::npos);
  }
  CHECK(result.quantities.size() == 78);  // the same keys for every bed
  for (const auto& q : result.quantities) {
    INFO(q.key);
    CHECK((q.value ? std::isfinite(*q.value) : !q.note.empty()));
    if (q.uncertainty) CHECK(std::isfinite(*q.uncertainty));
  }
}

TEST_CASE("a particle far away does not fill the memory") {
  Snapshot s = closed_bed(4, 4, 4);
  label(s, [](int x, int, int) { return x % 2; });
  s.domain.max = Vec3(1e9, 1e9, 1e9);
  const double far = GENERATE(1e9, 1e308);
  add_particle(s, Vec3(far, far, -far), s.radius.front(), 0);
  const auto result = measured(s, "segregation");
  const double p = 32.0 / 65;  // of the heavy, all of whom share a cell with 32 light
  const double variance = 64.0 / 65 * std::pow(0.5 - p, 2) + 1.0 / 65 * p * p;
  CHECK(value(result, "cell_intensity") == Approx(variance / (p * (1 - p))).epsilon(1e-6));
}

TEST_CASE("sizes of none, by number: chosen layers and cells work") {
  Snapshot s = closed_bed(4, 4, 4);
  label(s, [](int, int, int z) { return z < 2 ? 1 : 0; });
  std::fill(s.radius.begin(), s.radius.end(), 0.0);
  const auto result =
      measured(s, "segregation", {.segregation_layer = 2, .segregation_cell = 3, .segregation_by = ShareBy::number});
  CHECK(value(result, "cell_intensity") == Approx(1));
}

TEST_CASE("bad options are refused in one line") {
  const Snapshot s = closed_bed(2, 2, 2);
  CHECK_THROWS_AS(measured(s, "segregation", {.segregation_cell = -1}), InputError);
  CHECK_THROWS_AS(measured(s, "segregation", {.segregation_cell = std::nan("")}), InputError);
  CHECK_THROWS_AS(measured(s, "segregation", {.segregation_rings = -2}), InputError);
  CHECK_THROWS_AS(measured(s, "segregation", {.segregation_rings = 1}), InputError);
}
