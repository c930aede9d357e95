// The variances of random mixing against many random beds.
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "analysis/segregation/composition.hpp"
#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

struct Sample {
  double observed;  // s^2 over the types
  RandomMixing random;
  Composition composition;
};

Sample sample_of(const Snapshot& s, double thickness) {
  const BedFrame frame = bed_frame(s);
  const SpeciesList list = species_of(s);
  const Layers layers = layers_over_bed(frame, s.radius, thickness);
  const auto pieces = cut_into_layers(frame.height, s.radius, layers, Outside::to_nearest_layer);
  const auto composition = composition_of(pieces, layers, list.label, list.size());
  const auto variance = variance_over_layers(composition);
  return {std::accumulate(variance.begin(), variance.end(), 0.0),
          random_mixing(pieces, layers, list, composition, s.radius), composition};
}

struct Moments {
  double mean, error, deviation;
};

Moments moments(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (double v : values) squares += (v - mean) * (v - mean);
  const double deviation = std::sqrt(squares / (n - 1));
  return {mean, deviation / std::sqrt(n), deviation};
}

constexpr double sigmas = 4;

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
  const RandomMixing random = sample_of(s, thickness).random;
  REQUIRE_FALSE(random.size_linked);
  const Moments m = moments(observed);
  CHECK(std::abs(m.mean - random.expected) < sigmas * m.error);
  CHECK(random.total.mean == Approx(m.mean).epsilon(0.1));
  CHECK(random.total.deviation == Approx(m.deviation).epsilon(0.25));
}

TEST_CASE("random labels: every layer spreads as the formula says") {
  Snapshot s = cubic_bed(5, 5, 8);
  std::vector<double> squares;  // (c - P)^2 over its variance, of one layer
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    label_at_random(s, seed);
    const Sample sample = sample_of(s, 2.7);
    const double off = sample.composition.share(1, 0) - sample.composition.mean[0];
    squares.push_back(off * off / sample.random.variance[2]);
  }
  const Moments m = moments(squares);
  CHECK(std::abs(m.mean - 1) < sigmas * m.error);
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
  CHECK(std::abs(index.mean - 1) < sigmas * index.error);
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
    REQUIRE(sample.random.size_linked);
    ratio.push_back(sample.observed / sample.random.expected);
    observed.push_back(sample.observed);
    predicted_deviation = sample.random.total.deviation;
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
  REQUIRE_FALSE(equal.random.size_linked);
  REQUIRE(other.random.size_linked);
  CHECK(other.random.expected == Approx(equal.random.expected).epsilon(0.1));
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
