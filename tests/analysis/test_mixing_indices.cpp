// Mixing indices of layers, rings, cells and contacts against exact results and the theory of random mixing.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <catch2/catch.hpp>
#include <omp.h>

#include "analysis/segregation/contact_mixing.hpp"
#include "core/error.hpp"
#include "tests/analysis/fixtures.hpp"
#include "tests/analysis/moments.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

/// A closed cubic bed divided exactly: layers of one particle, cells of 2 x 2 x 2.
MeasureResult indices_of(const Snapshot& s, Options options = {}) {
  options.segregation_layer = 2;
  options.segregation_cell = 4;
  return measured(s, "segregation", options);
}

Snapshot closed_bed(int nx, int ny, int nz) { return cubic_bed(nx, ny, nz, {false, false, false}); }

/// Types in order of the rows, of the counts given, at random.
void label_at_random(Snapshot& s, const std::vector<int>& counts, std::uint64_t seed) {
  std::vector<int> types;
  for (std::size_t k = 0; k < counts.size(); ++k) types.insert(types.end(), counts[k], static_cast<int>(k));
  Random random(seed, RandomStream::filling_order, 0);
  shuffle(types, random);
  s.type = types;
}

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

constexpr double sigmas = 4;

}  // namespace

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

TEST_CASE("indices that do not exist say why; none is ever NaN") {
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
