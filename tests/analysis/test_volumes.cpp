// Exact volumes against numerical integration.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "analysis/packing/lens.hpp"
#include "core/geometry.hpp"

using namespace packstone;

namespace {

/// Midpoint rule in extended precision.
template <class Area>
double integral(double from, double to, Area&& area) {
  constexpr int panels = 1'000'000;
  const long double h = (static_cast<long double>(to) - from) / panels;
  long double sum = 0;
  for (int k = 0; k < panels; ++k) sum += area(from + h * (k + 0.5L));
  return static_cast<double>(sum * h);
}

long double disc(long double r, long double z) {
  return std::numbers::pi_v<long double> * std::max(0.0L, r * r - z * z);
}

}  // namespace

TEST_CASE("sphere slabs agree with quadrature") {
  const double r = 0.7, z = 0.3;
  const double lower = GENERATE(-1.0, -0.4, -0.1, 0.29, 0.6);
  const double upper = lower + GENERATE(0.05, 0.3, 2.0);
  const double from = std::max(lower, z - r), to = std::min(upper, z + r);
  const double expected = to > from ? integral(from, to, [&](long double x) { return disc(r, x - z); }) : 0.0;
  CHECK(sphere_slab_volume(r, z, lower, upper) == Approx(expected).margin(1e-10));
}

TEST_CASE("lens volumes agree with quadrature") {
  const double r1 = 1.0, r2 = GENERATE(1.0, 0.5, 0.1);
  const double overlap = r2 * GENERATE(1e-3, 0.1, 0.7, 1.5);
  const double d = r1 + r2 - overlap;
  const auto common = [&](long double x) { return std::min(disc(r1, x), disc(r2, x - d)); };
  const double expected = integral(d - r2, std::min(r1, d + r2), common);
  CHECK(analysis::lens_volume(r1, r2, overlap) == Approx(expected).margin(1e-10));
}

TEST_CASE("lens volume at its limits") {
  CHECK(analysis::lens_volume(1, 1, 0) == 0);
  CHECK(analysis::lens_volume(1, 1, -0.1) == 0);
  CHECK(analysis::lens_volume(1, 0.5, 1.0) == Approx(sphere_volume(0.5)));
  CHECK(analysis::lens_volume(1, 0.5, 1.4) == Approx(sphere_volume(0.5)));
  CHECK(analysis::lens_volume(1, 1, 2) == Approx(sphere_volume(1)));
}
