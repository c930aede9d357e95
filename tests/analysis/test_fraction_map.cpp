// The local solid fraction on a grid, and its file.
#include <cstring>
#include <numbers>

#include <catch2/catch.hpp>
#include <omp.h>

#include "analysis/packing/fraction_map.hpp"
#include "analysis/packing/overlap_volume.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/fixtures.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;

namespace {

/// Radii over two decades at random places, one sphere larger than many cells.
Snapshot mixture(std::array<bool, 3> periodic) {
  Snapshot s = empty_box(Vec3(6, 5, 4), periodic);
  Random random(5, RandomStream::filling_position, 0);
  for (int i = 0; i < 400; ++i) {
    const double r = i == 0 ? 1.7 : std::exp2(random.uniform(-5, -1));
    add_particle(s, Vec3(random.uniform(0, 6), random.uniform(0, 5), random.uniform(0, 4)), r);
  }
  return s;
}

analysis::FractionMap map_of(const Snapshot& s, const analysis::Options& options = {}) {
  const auto context = analysis::make_context(s, options);
  return analysis::fraction_map(s, context, analysis::container_of(s, context.frame));
}

}  // namespace

TEST_CASE("every cell of the map holds the exact parts of all spheres") {
  const Snapshot s = mixture({true, true, true});
  const auto map = map_of(s, {.map_cell = 0.5});
  REQUIRE(map.count == std::array<std::size_t, 3>{12, 10, 8});
  double total = 0, worst = 0;
  for (std::size_t k = 0; k < map.cells(); ++k) {
    const auto cell = map.cell(k % 12, k / 12 % 10, k / 120);
    double solid = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (int image = 0; image < 27; ++image) {
        const Vec3 shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
        const Vec3 centre = s.position[i] + shift.cwiseProduct(s.domain.size());
        solid += analysis::sphere_box_volume(centre, s.radius[i], cell.min, cell.max);
      }
    }
    worst = std::max(worst, std::abs(map.fraction[k] - solid / 0.125));
    total += map.fraction[k] * 0.125;
  }
  CHECK(worst < 1e-12);
  double expected = 0;
  for (double r : s.radius) expected += sphere_volume(r);
  CHECK(total == Approx(expected).epsilon(1e-13));
}

TEST_CASE("the map covers the container from the floor to the highest sphere") {
  Snapshot s = cubic_bed(5, 5, 10, {false, false, false});
  s.domain.max.z() = 100;
  const auto map = map_of(s);
  CHECK(map.origin == Vec3(0, 0, 0));
  CHECK(map.spacing.isApprox(Vec3(2, 2, 2.00000005), 1e-9));
  for (double f : map.fraction) CHECK(f == Approx(std::numbers::pi / 6).epsilon(1e-5));
  const auto spread = measured(s, "packing", {.interior_margin = 1});
  CHECK(value(spread, "map_fraction_mean") == Approx(std::numbers::pi / 6).epsilon(1e-5));
  CHECK(value(spread, "map_fraction_deviation") < 1e-5);
  CHECK(value(spread, "map_cell") == Approx(2).epsilon(1e-6));
}

TEST_CASE("the spread of local fractions is that over cells in the interior") {
  // Cells of one lattice cell each, every second one empty: fractions 0 and pi / 6.
  Snapshot s = empty_box(Vec3(8, 8, 8), {true, true, true});
  for (int k = 0; k < 64; ++k) {
    const Vec3 cell(k % 4, k / 4 % 4, k / 16);
    if (static_cast<int>(cell.sum()) % 2 == 0) add_particle(s, 2 * cell + Vec3::Ones(), 1);
  }
  const auto packing = measured(s, "packing", {.map_cell = 2});
  CHECK(value(packing, "map_fraction_mean") == Approx(std::numbers::pi / 12).epsilon(1e-13));
  CHECK(value(packing, "map_fraction_deviation") ==
        Approx(std::numbers::pi / 12 * std::sqrt(64.0 / 63)).epsilon(1e-13));
}

TEST_CASE("the map does not depend on the number of threads") {
  const Snapshot s = mixture({true, false, false});
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = map_of(s, {.map_cell = 0.1});
  omp_set_num_threads(3);
  const auto three = map_of(s, {.map_cell = 0.1});
  omp_set_num_threads(before);
  CHECK(one.fraction == three.fraction);
}

TEST_CASE("a map's size is bounded") {
  CHECK_THROWS_WITH(map_of(mixture({true, true, true}), {.map_cell = 0.001}), Contains("at most 5e+07"));
  // A few particles far apart for their size take wider cells of themselves.
  Snapshot s = empty_box(Vec3(1, 1, 1), {false, false, false});
  add_particle(s, Vec3(0.5, 0.5, 0.9), 1e-6);
  const auto map = map_of(s);
  CHECK(map.cells() > 1000);
  CHECK(map.cells() < 10000);
  CHECK(map_of(empty_box(Vec3(1, 1, 1))).cells() == 0);
}

TEST_CASE("a map is written as VTK image data") {
  const Snapshot s = mixture({true, true, true});
  const testing::TemporaryFolder folder;
  const auto path = folder / "map.vti";
  analysis::write_fraction_map(path, s, {.map_cell = 0.5});
  const std::string text = read_text_file(path);
  CHECK_THAT(text, Contains("WholeExtent=\"0 12 0 10 0 8\" Origin=\"0 0 0\" Spacing=\"0.5 0.5 0.5\""));
  const std::size_t data = text.find("\n_") + 2;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, &text[data], sizeof bytes);
  REQUIRE(bytes == 960 * sizeof(double));
  std::vector<double> values(960);
  std::memcpy(values.data(), &text[data + sizeof bytes], bytes);
  CHECK(values == map_of(s, {.map_cell = 0.5}).fraction);
  CHECK(text.substr(data + sizeof bytes + bytes) == "\n  </AppendedData>\n</VTKFile>\n");
  CHECK_THROWS_WITH(analysis::write_fraction_map("map.vtk", s, {}), Contains("must end in .vti"));
  CHECK_THROWS_WITH(analysis::write_fraction_map("map.vti", empty_box(Vec3(1, 1, 1)), {}), Contains("nothing to map"));
}
