// The variances of random mixing against many random beds.
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "analysis/segregation/arrangement.hpp"
#include "tests/analysis/fixtures.hpp"
#include "tests/analysis/moments.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

/// The layers of a bed, and what random mixing makes of them.
struct Sample {
  double observed;               // s^2 over the types
  double expected;               // of s^2
  bool linked;                   // sizes to types
  std::vector<double> variance;  // (layers * types) of a share
  Composition composition;
};

Sample sample_of(const Snapshot& s, double thickness) {
  const Context context = make_context(s, {.segregation_layer = thickness});
  const MixedBed bed = mixed_bed(s, context);
  const DividedBed& layers = bed.parts[layers_part];
  const auto by_species = variance_by_species(layers.composition);
  const auto variances = random_variance(layers.division, bed.list, bed.amounts, layers.composition);
  return {std::accumulate(by_species.begin(), by_species.end(), 0.0), expected_variance(variances, layers.composition),
          bed.amounts.linked, variances, layers.composition};
}

/// Of s^2 over random arrangements.
RandomReference random_arrangements(const Snapshot& s, double thickness) {
  const Context context = make_context(s, {.segregation_layer = thickness});
  return mixing_numbers(mixed_bed(s, context)).random[index_of(layers_part, variance)];
}

constexpr double most_sigmas = 4;

}  // namespace

TEST_CASE("random labels: the mean of s^2 is the formula's, cut particles and all") {
  Snapshot s = cubic_bed(5, 5, 12);
  SECTION("equal spheres") {}
  SECTION("sizes that do not depend on the type") {
    for (std::size_t i = 0; i < s.size(); ++i) s.radius[i] = 0.6 + 0.4 * static_cast<double>(i % 7) / 6;
  }
  const double thickness = 2.7;  // cuts most spheres
  std::vector<double> observed;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    label_at_random(s, seed);
    observed.push_back(sample_of(s, thickness).observed);
  }
  const Sample random = sample_of(s, thickness);
  REQUIRE_FALSE(random.linked);
  const Moments m = moments(observed);
  CHECK(std::abs(m.mean - random.expected) < most_sigmas * m.error);
  const RandomReference arranged = random_arrangements(s, thickness);
  CHECK(arranged.mean == Approx(m.mean).epsilon(0.1));
  CHECK(arranged.deviation == Approx(m.deviation).epsilon(0.25));
}

TEST_CASE("random labels: every layer spreads as the formula says") {
  Snapshot s = cubic_bed(5, 5, 8);
  std::vector<double> squares;  // (c - P)^2 over its variance, of one layer
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    label_at_random(s, seed);
    const Sample sample = sample_of(s, 2.7);
    const double off = sample.composition.share(1, 0) - sample.composition.mean[0];
    squares.push_back(off * off / sample.variance[2]);
  }
  const Moments m = moments(squares);
  CHECK(std::abs(m.mean - 1) < most_sigmas * m.error);
}

TEST_CASE("random labels: Lacey's index is 1 on average, within its own spread") {
  Snapshot s = cubic_bed(6, 6, 10);
  std::vector<double> lacey, z;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    label_at_random(s, seed);
    const auto result = measured(s, "segregation");
    lacey.push_back(value(result, "lacey"));
    z.push_back(value(result, "lacey_z"));
  }
  const Moments index = moments(lacey), score = moments(z);
  CHECK(std::abs(index.mean - 1) < most_sigmas * index.error);
  CHECK(std::abs(score.mean) < 0.5);
  CHECK(score.deviation == Approx(1).epsilon(0.3));
}

TEST_CASE("sizes linked to types: the sampling variance holds for random positions") {
  std::vector<double> ratio;
  Moments spread{};
  double predicted_deviation = 0;
  std::vector<double> observed;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Snapshot s = empty_box(Vec3(20, 20, 40), {true, true, true});
    Random random(seed, RandomStream::filling_position, 1);
    for (int i = 0; i < 1500; ++i) {
      const Vec3 p(random.uniform(0, 20), random.uniform(0, 20), random.uniform(0, 40));
      add_particle(s, p, i < 300 ? 1.0 : 0.5, i < 300 ? 1 : 0);
    }
    const Sample sample = sample_of(s, 4);
    REQUIRE(sample.linked);
    ratio.push_back(sample.observed / sample.expected);
    observed.push_back(sample.observed);
    if (seed == 0) predicted_deviation = random_arrangements(s, 4).deviation;
  }
  spread = moments(observed);
  CHECK(moments(ratio).mean == Approx(1).epsilon(0.1));  // first order
  CHECK(predicted_deviation == Approx(spread.deviation).epsilon(0.35));
}

TEST_CASE("both variances agree for equal spheres") {
  // One sphere a little larger links size to type by the letter, yet changes nothing else.
  Snapshot s = cubic_bed(6, 6, 8);
  label_at_random(s, 1);
  const Sample equal = sample_of(s, 2.7);
  Snapshot linked = s;
  for (std::size_t i = 0; i < s.size(); ++i) linked.radius[i] *= s.type[i] == 1 ? 1.0 : 1.1;
  const Sample other = sample_of(linked, 2.7);
  REQUIRE_FALSE(equal.linked);
  REQUIRE(other.linked);
  CHECK(other.expected == Approx(equal.expected).epsilon(0.1));
}

TEST_CASE("permutations keep the counts and depend on their number alone") {
  const std::vector<std::int32_t> labels = {0, 0, 0, 1, 1, 2};
  auto first = permuted(labels, 3);
  CHECK(first == permuted(labels, 3));
  std::sort(first.begin(), first.end());
  CHECK(first == labels);
  CHECK(permutation_count(10) == 200);
  CHECK(permutation_count(1'000'000) == 20);
}
