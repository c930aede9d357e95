// What random mixing gives, against its theory.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <catch2/catch.hpp>

#include "analysis/segregation/contact_mixing.hpp"
#include "tests/analysis/mixed_beds.hpp"
#include "tests/analysis/moments.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

/// Mean and variance of Pearson's chi^2 of a table of fixed margins filled at random: rows are types, columns cells
/// (Dawson, Biometrika 41 (1954) 280).
struct ChiSquare {
  double mean, variance;
};

ChiSquare chi_square(const std::vector<int>& rows, const std::vector<int>& columns) {
  const double n = std::accumulate(rows.begin(), rows.end(), 0.0);
  const auto v = [&](double count) { return (count - 1) * (n - count) / (n - 1); };
  const auto w = [&](const std::vector<int>& margin) {
    double sum = 0;
    for (int m : margin) sum += n / m;
    const double count = static_cast<double>(margin.size());
    return (sum - count * count) / (n - 2);
  };
  const double r = static_cast<double>(rows.size()), c = static_cast<double>(columns.size());
  return {n * (r - 1) * (c - 1) / (n - 1),
          2 * n / (n - 3) * (v(r) - w(rows)) * (v(c) - w(columns)) + n * n / (n - 1) * w(rows) * w(columns)};
}

/// Variance of the number of unlike joins when two types lie at random on a network: from the chances that one, two
/// adjoining and two separate joins are unlike (Moran, J. R. Stat. Soc. B 10 (1948) 243).
double unlike_join_variance(const std::vector<NearPair>& joins, double first, double second) {
  const double n = first + second, m = static_cast<double>(joins.size());
  std::vector<double> degree(static_cast<std::size_t>(n), 0.0);
  for (const auto& join : joins) ++degree[join.first], ++degree[join.second];
  double adjoining = 0;  // ordered pairs of joins that share a particle
  for (double d : degree) adjoining += d * (d - 1);
  const double one = 2 * first * second / (n * (n - 1));
  const double at_corner = first * second / (n * (n - 1));  // x y x or y x y
  const double apart = 4 * first * (first - 1) * second * (second - 1) / (n * (n - 1) * (n - 2) * (n - 3));
  return m * one + adjoining * at_corner + (m * (m - 1) - adjoining) * apart - m * m * one * one;
}

}  // namespace

TEST_CASE("random labels: intensity in cells has the mean and the spread of chi^2 with fixed margins") {
  Snapshot s = closed_bed(8, 8, 8);
  s.groups.push_back({"third", "light", 2000});
  s.domain.periodic = {true, true, true};
  std::vector<int> counts;
  SECTION("two types") { counts = {128, 384}; }
  SECTION("three types of equal number") { counts = {171, 171, 170}; }
  label_at_random(s, counts, 1);
  const auto result = indices_of(s);
  const std::vector<int> cells(64, 8);
  const ChiSquare chi = chi_square(counts, cells);
  // Equal numbers of the types, or two of them, make I = chi^2 / (N (types - 1)).
  const double scale = 512.0 * (static_cast<double>(counts.size()) - 1);
  const Quantity& random = *result.quantity("cell_intensity_random");
  const double deviation = std::sqrt(chi.variance) / scale, samples = permutation_count(512);
  CHECK(std::abs(*random.value - chi.mean / scale) < sigmas * deviation / std::sqrt(samples));
  CHECK(*random.uncertainty == Approx(deviation).epsilon(sigmas / std::sqrt(2 * samples)));
  // The band of a nearly normal number; the spread of such a percentile is about 2.7 deviations over sqrt(samples).
  const double slack = sigmas * 2.7 * deviation / std::sqrt(samples);
  CHECK(std::abs(*result.quantity("cell_intensity_random_low")->value - (*random.value - 1.96 * deviation)) < slack);
  CHECK(std::abs(*result.quantity("cell_intensity_random_high")->value - (*random.value + 1.96 * deviation)) < slack);
}

TEST_CASE("random labels: contacts between unlike particles spread as join counts do") {
  Snapshot s = closed_bed(8, 8, 8);
  label_at_random(s, std::vector<int>{128, 384}, 2);
  const auto result = indices_of(s);
  const auto joins = make_context(s, {}).contacts.pairs;
  const double expected = 2.0 * 128 * 384 / (512.0 * 511);
  const double deviation =
      std::sqrt(unlike_join_variance(joins, 128, 384)) / static_cast<double>(joins.size()) / expected;
  const double samples = permutation_count(512);
  const Quantity& random = *result.quantity("contact_mixing_random");
  CHECK(std::abs(*random.value - 1) < sigmas * deviation / std::sqrt(samples));
  CHECK(*random.uncertainty == Approx(deviation).epsilon(sigmas / std::sqrt(2 * samples)));
}

TEST_CASE("random labels: the centres' distance has the variance of a sample without replacement") {
  Snapshot s = closed_bed(8, 8, 8);
  label_at_random(s, std::vector<int>{128, 384}, 3);
  // Mean square distance: 3 axes, population variance 4 (8^2 - 1) / 12, times N / (N - 1) (1/n + 1/m).
  const double square = 3 * 4 * 63.0 / 12 * 512 / 511 * (1.0 / 128 + 1.0 / 384);
  const auto result = indices_of(s);
  const Quantity& random = *result.quantity("centre_distance_random");
  const double found = *random.value * *random.value + *random.uncertainty * *random.uncertainty;
  // The square is chi^2 of 3 degrees over 3: relative deviation sqrt(2/3).
  CHECK(found == Approx(square).epsilon(sigmas * std::sqrt(2.0 / 3 / permutation_count(512))));
}

TEST_CASE("z-scores of random labels are standard normal, Lacey's index is 1 on average") {
  Snapshot s = closed_bed(6, 6, 6);
  const std::vector<std::string> indices = {"lacey",          "intensity",    "entropy",
                                            "ring_intensity", "cell_lacey",   "cell_intensity",
                                            "cell_rsd",       "cell_entropy", "contact_mixing"};
  constexpr int seeds = 200;
  std::map<std::string, std::vector<double>> z;
  std::vector<double> lacey;
  for (int seed = 0; seed < seeds; ++seed) {
    label_at_random(s, std::vector<int>{72, 144}, static_cast<std::uint64_t>(seed));
    const auto result = indices_of(s);
    for (const auto& index : indices) z[index].push_back(value(result, index + "_z"));
    lacey.push_back(value(result, "cell_lacey"));
  }
  for (const auto& index : indices) {
    INFO(index);
    const Moments m = moments(z[index]);
    // The reference's own mean, from 200 arrangements and the same for all seeds, shifts all z by 1 / sqrt(200).
    const double error = std::sqrt(1.0 / seeds + 1.0 / permutation_count(216));
    CHECK(std::abs(m.mean) < sigmas * error);
    // Likewise two variances from 200 each; the kurtosis of these numbers is below 4.
    CHECK(m.deviation * m.deviation == Approx(1).epsilon(sigmas * std::sqrt((4.0 - 1) * (1.0 / seeds + 1.0 / 200))));
  }
  const Moments m = moments(lacey);
  CHECK(std::abs(m.mean - 1) < sigmas * m.error);
}

TEST_CASE("sizes linked to types: Stange's variance for cells of a random mixture") {
  // A lattice of places; large spheres (r = 1) and small ones (r = 0.8) lie on it at random, eight to a cell.
  Snapshot s = closed_bed(8, 8, 8);
  label_at_random(s, std::vector<int>{384, 128}, 5);
  for (std::size_t i = 0; i < s.size(); ++i) s.radius[i] = s.type[i] == 1 ? 1.0 : 0.8;
  s.domain.periodic = {true, true, true};  // cells of edge 4 exactly
  const double large = 1, small = 0.512;   // volumes in 4/3 pi
  const double total = 128 * large + 384 * small, p = 128 * large / total;
  const double cell = total / 64;
  // Finite population: a cell is 8 of 512.
  const double stange = p * (1 - p) * ((1 - p) * large + p * small) / cell * (512.0 - 8) / 511;
  const auto result = indices_of(s);
  const Quantity& random = *result.quantity("cell_intensity_random");
  // Both types have that variance; first order in 1/8.
  CHECK(*random.value == Approx(stange / (p * (1 - p))).epsilon(0.08));
  CHECK(value(result, "cell_lacey_random") == Approx(1).epsilon(1e-12));
  CHECK(std::abs(value(result, "cell_lacey_z")) < sigmas);
  CHECK(result.quantity("cell_lacey_random_low")->value);
}

TEST_CASE("contacts of types that differ in size: ends joined at random") {
  // Against all matchings of six ends: A (2 ends), B (1), C (1), D (2) in contacts AB, AC, DD' with types 0 0 1 1.
  SpeciesList list;
  list.species = {{0, "small", 2}, {1, "large", 3}};
  list.label = {0, 0, 1, 1, 1};
  const std::vector<NearPair> contacts = {{0, 1, 0}, {0, 2, 0}, {3, 4, 0}};
  const std::vector<int> ends = {0, 0, 0, 1, 1, 1};
  std::vector<double> shares;
  std::vector<int> order = {0, 1, 2, 3, 4, 5};
  do {
    double unlike = 0;
    for (int k = 0; k < 6; k += 2) unlike += ends[order[k]] != ends[order[k + 1]] ? 1 : 0;
    shares.push_back(unlike / 3);
  } while (std::next_permutation(order.begin(), order.end()));
  const Moments all = moments(shares);
  const RandomReference random = unlike_share_of_ends(contacts, list);
  CHECK(random.mean == Approx(all.mean).epsilon(1e-12));
  CHECK(random.deviation == Approx(all.deviation * std::sqrt(719.0 / 720)).epsilon(1e-12));
}
