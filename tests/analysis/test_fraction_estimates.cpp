// Points and voxels against exact volumes: they agree, and their errors fall as they must.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "analysis/packing/fraction_estimates.hpp"
#include "core/error.hpp"
#include "tests/analysis/random_packings.hpp"

using namespace packstone;
using namespace packstone::analysis;
using Catch::Matchers::Contains;

namespace {

/// Spheres of two sizes that overlap and cross the periodic sides.
Snapshot mixed_gas() {
  Snapshot gas = fixtures::ideal_gas(200, Vec3(8, 8, 10), {true, true, false}, 5);
  for (std::size_t i = 0; i < gas.size(); i += 3) gas.radius[i] = 0.9;
  return gas;
}

const std::vector<RegionShape> regions = {
    BoxRegion{Vec3(0, 0, 2), Vec3(8, 8, 8)}, BoxRegion{Vec3(1, 2, 3), Vec3(4, 7, 9)},
    RingRegion{.axis = 2, .centre = Vec3(4, 4, 0), .inner = 1, .outer = 3.5, .lower = 1, .upper = 9}};

/// Root mean square deviation from the exact fraction over seeds.
template <class Estimate>
double deviation(double exact, Estimate&& estimate) {
  constexpr int seeds = 24;
  double squares = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) squares += std::pow(estimate(seed) - exact, 2);
  return std::sqrt(squares / seeds);
}

}  // namespace

TEST_CASE("Points and voxels find the exact solid fraction of any region") {
  const Snapshot gas = mixed_gas();
  for (const RegionShape& region : regions) {
    const double exact = exact_fraction(gas, region);
    CHECK(sampled_fraction(gas, region, 200'000, PointSet::random, 1) == Approx(exact).margin(0.006));
    CHECK(sampled_fraction(gas, region, 200'000, PointSet::even, 1) == Approx(exact).margin(0.001));
    CHECK(voxel_fraction(gas, region, 0.05, 1) == Approx(exact).margin(0.001));
  }
}

TEST_CASE("The error of points falls like one over the root of their number, that of even points and voxels faster") {
  const Snapshot gas = mixed_gas();
  const RegionShape& region = regions.front();
  const double exact = exact_fraction(gas, region);
  const auto points = [&](PointSet set, std::size_t count) {
    return deviation(exact, [&](std::uint64_t seed) { return sampled_fraction(gas, region, count, set, seed); });
  };
  // Sixteen times the points; a deviation over 24 seeds is known to a seventh.
  CHECK(points(PointSet::random, 1000) / points(PointSet::random, 16'000) == Approx(4).epsilon(0.45));
  CHECK(points(PointSet::even, 1000) / points(PointSet::even, 16'000) > 5);
  const auto voxels = [&](double edge) {
    return deviation(exact, [&](std::uint64_t seed) { return voxel_fraction(gas, region, edge, seed); });
  };
  const double order = std::log2(voxels(0.5) / voxels(0.125)) / 2;
  CHECK(order > 1);
  CHECK(order < 2.6);
}

TEST_CASE("The bulk's region is that of the measure's bulk fraction") {
  const Snapshot bed = fixtures::cubic_bed(4, 4, 12);
  const Context context = make_context(bed);
  CHECK(exact_fraction(bed, bulk_region(bed, context)) == Approx(context.bed.bulk_fraction).epsilon(1e-9));
  const Snapshot crystal = fixtures::lattice(fixtures::face_centred, 2, 2, 2, 1, std::numbers::sqrt2 / 4);
  CHECK(exact_fraction(crystal, bulk_region(crystal, make_context(crystal))) ==
        Approx(std::numbers::pi / (3 * std::numbers::sqrt2)));
}

TEST_CASE("Voxels that are too many or too large are refused, and so is a bed that is not there") {
  const Snapshot gas = mixed_gas();
  CHECK_THROWS_WITH(voxel_fraction(gas, regions.front(), 1e-4, 1), Contains("are the most"));
  CHECK_THROWS_WITH(voxel_fraction(gas, BoxRegion{Vec3::Zero(), Vec3::Constant(0.01)}, 1, 1), Contains("too large"));
  const Snapshot empty = fixtures::empty_box(Vec3::Ones());
  CHECK_THROWS_AS(bulk_region(empty, make_context(empty)), InputError);
}
