// Roots in lanes against the library's.
#include <cmath>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "engine/simd/lanes.hpp"

using namespace packstone;
using namespace packstone::engine::simd;

namespace {

/// Largest relative error of a root over numbers of many sizes.
template <class Lanes, class Root, class Exact>
double largest_error(const Root& root, const Exact& exact) {
  double largest = 0;
  Random random(1, RandomStream::filling_position, 0);
  for (int n = 0; n < 20000; ++n) {
    const double x = static_cast<float>(std::exp(random.uniform(-40, 40)));
    const typename Lanes::Real y = root(typename Lanes::Real(x));
    for (int lane = 0; lane < Lanes::width; ++lane) {
      largest = std::max(largest, std::abs(Lanes::lane(y, lane) / exact(x) - 1));
    }
  }
  return largest;
}

template <class Lanes>
void check_roots(double tolerance) {
  INFO(Lanes::name);
  using Real = typename Lanes::Real;
  CHECK(largest_error<Lanes>([](Real x) { return cube_root(x); }, [](double x) { return std::cbrt(x); }) < tolerance);
  CHECK(largest_error<Lanes>([](Real x) { return square_root(x); }, [](double x) { return std::sqrt(x); }) < tolerance);
  CHECK(largest_error<Lanes>([](Real x) { return inverse_sqrt(x); }, [](double x) { return 1 / std::sqrt(x); }) <
        tolerance);
  CHECK(Lanes::lane(cube_root(Real(0.0)), 0) == 0);
  CHECK(Lanes::lane(cube_root(Real(1.0)), 0) == Approx(1).epsilon(tolerance));
}

constexpr double double_precision = 1e-15, single_precision = 4e-7;

}  // namespace

TEST_CASE("roots in lanes are those of the library") {
  check_roots<Scalar>(double_precision);
  check_roots<ScalarSingle>(single_precision);
#ifdef PACKSTONE_AVX2
  check_roots<Avx2>(double_precision);
  check_roots<Avx2Single>(single_precision);
#endif
#ifdef PACKSTONE_AVX512
  check_roots<Avx512>(double_precision);
  check_roots<Avx512Single>(single_precision);
#endif
}
