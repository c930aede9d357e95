// How far single precision is off, as docs/physics.md states it.
#include <cmath>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "engine/dynamics/precision.hpp"
#include "engine/force_resolution.hpp"
#include "engine/simd/lanes.hpp"

using namespace packstone;
using namespace packstone::engine;

namespace {

struct Rounding {
  double rms = 0, largest = 0;  ///< of overlaps, in mean radii of the pair
};

/// Over pairs anywhere in a periodic box, in any direction, with overlaps around 1e-5 of the small radius.
Rounding rounding_of_overlaps(double ratio) {
  using Mixed = MixedPrecision<simd::ScalarSingle>;
  constexpr int pairs = 20000;
  const double small = 5e-3, large = ratio * small, mean = 0.5 * (small + large);
  const Domain domain{Vec3::Zero(), Vec3::Constant(100 * large), {true, true, true}};
  Rounding rounding;
  for (int k = 0; k < pairs; ++k) {
    Random r(11, RandomStream::filling_position, static_cast<std::uint64_t>(k));
    const auto vector = [&](double low, double high) {
      return Vec3(r.uniform(low, high), r.uniform(low, high), r.uniform(low, high));
    };
    Particles p;
    p.count = 2;
    p.id = {0, 1, Particles::no_particle};
    p.now.rows.resize(3);
    const double reach = static_cast<double>(static_cast<float>(small)) + static_cast<float>(large);
    const double overlap = 2e-5 * small * r.uniform();
    const Vec3 there = vector(0, 100 * large);
    p.now.rows[0] = {domain.wrapped(there + (reach - overlap) * vector(-1, 1).normalized()), small, Vec3::Zero(), 1};
    p.now.rows[1] = {there, large, Vec3::Zero(), 1};
    p.make_compact(domain.size() / 12, 0.5 * domain.size());  // just over eight extents
    const Mixed seen(p, domain);
    const std::uint32_t neighbour = Row::doubles;
    float radius = 0;
    const auto self = seen.bodies_in_line<false>(0);
    const simd::Vector<float> d = seen.separation<false>(self, &neighbour, true, radius);
    const float squared = squared_length(d);
    const double exact = reach - domain.separation(p.now.rows[0].position, p.now.rows[1].position).norm();
    const double off = (Mixed::overlap(self.radius + radius, squared, simd::inverse_sqrt(squared)) - exact) / mean;
    rounding.rms += off * off / pairs;
    rounding.largest = std::max(rounding.largest, std::abs(off));
  }
  rounding.rms = std::sqrt(rounding.rms);
  return rounding;
}

}  // namespace

TEST_CASE("overlaps in single precision are off by what is stated, at any ratio of sizes") {
  const double ratio = GENERATE(1.0, 3.0, 10.0, 50.0);
  const Rounding rounding = rounding_of_overlaps(ratio);
  INFO("ratio " << ratio << ": rms " << rounding.rms << ", largest " << rounding.largest);
  CHECK(rounding.rms < 1.5 * single_resolution);
  CHECK(rounding.rms > 0.5 * single_resolution);
  CHECK(rounding.largest < 6 * single_resolution);
}
