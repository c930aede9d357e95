// The radial distribution function: ideal gases, lattices, all pairs.
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "analysis/species.hpp"
#include "analysis/structure/pair_distribution.hpp"
#include "core/error.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/random_packings.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

Window whole(const Snapshot& s) { return {s.domain.min, s.domain.max, s.domain.periodic}; }

double shell(double lower, double upper) { return sphere_volume(upper) - sphere_volume(lower); }

/// g = 1 within the errors: chi^2 a bin near 1, the weighted mean of g - 1 near 0. Both sides of chi^2 test the errors.
void check_ideal(const PairCurve& curve) {
  double squares = 0, sum = 0, weights = 0;
  int bins = 0;
  for (std::size_t k = 0; k < curve.g.size(); ++k) {
    if (!(curve.error[k] > 0) || curve.error[k] > 0.2) continue;  // few pairs: not normal
    const double off = curve.g[k] - 1;
    squares += off * off / (curve.error[k] * curve.error[k]);
    sum += off / (curve.error[k] * curve.error[k]);
    weights += 1 / (curve.error[k] * curve.error[k]);
    ++bins;
  }
  REQUIRE(bins >= 20);
  CHECK(squares / bins == Approx(1).margin(4 * std::sqrt(2.0 / bins)));
  CHECK(std::abs(sum / weights) < 4 / std::sqrt(weights));
}

/// Mean share of the shells of radius r around the particles of a type that lies in the window, on a fine grid of
/// directions.
double brute_share(const Snapshot& s, const Window& w, int type, double r) {
  const int rings = 40, steps = 80;
  double inside = 0, all = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.type[i] != type || !w.contains(s.position[i])) continue;
    for (int a = 0; a < rings; ++a) {
      for (int b = 0; b < steps; ++b) {
        const double z = (a + 0.5) * 2 / rings - 1, phi = (b + 0.5) * 2 * EIGEN_PI / steps;
        Vec3 p =
            s.position[i] + r * Vec3(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
        inside += w.contains(s.domain.wrapped(p));
        ++all;
      }
    }
  }
  return inside / all;
}

/// The estimator as its definition says it, all particles being references.
double brute_g(const Snapshot& s, const Window& w, int a, int b, double lower, double upper) {
  double pairs = 0, n_a = 0, n_b = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!w.contains(s.position[i])) continue;
    n_a += s.type[i] == a;
    n_b += s.type[i] == b;
    for (std::size_t j = 0; j < s.size(); ++j) {
      if (i == j || s.type[i] != a || s.type[j] != b || !w.contains(s.position[j])) continue;
      const double r = s.domain.separation(s.position[j], s.position[i]).norm();
      pairs += r >= lower && r < upper;
    }
  }
  const double r = (lower + upper) / 2;
  const double x = 1 / w.size().x(), z = 1 / w.size().z();  // periodic along y
  const double mean_share = 1 - r / 2 * (x + z) + 2 / (3 * EIGEN_PI) * r * r * x * z;
  const double seen = brute_share(s, w, a, r) * brute_share(s, w, b, r) / mean_share;
  return pairs * w.volume() / (n_a * (a == b ? n_a - 1 : n_b) * seen * shell(lower, upper));
}

}  // namespace

TEST_CASE("an ideal gas has g = 1 at all distances, with sides and without") {
  SECTION("periodic, half of the side") {
    const Snapshot s = ideal_gas(4000, Vec3(10, 10, 10), {true, true, true}, 1);
    const auto d = pair_distribution(s, whole(s), s.type, 2, 0.1, 50);
    CHECK(d.references == 4000);
    check_ideal(d.total);
    for (const PairCurve& curve : d.partial) check_ideal(curve);
  }
  SECTION("hard sides, as far as half of the shortest") {
    const Snapshot s = ideal_gas(4000, Vec3(8, 10, 12), {false, false, false}, 2);
    const auto d = pair_distribution(s, whole(s), s.type, 2, 0.1, 40);
    check_ideal(d.total);
    for (const PairCurve& curve : d.partial) check_ideal(curve);
  }
  SECTION("a window cut off from a periodic side") {
    const Snapshot s = ideal_gas(4000, Vec3(10, 10, 10), {true, true, true}, 4);
    const Window cut{Vec3(1, 0, 0), Vec3(9, 10, 10), {false, true, true}};
    const auto d = pair_distribution(s, cut, s.type, 2, 0.1, 40);
    check_ideal(d.total);
    for (const PairCurve& curve : d.partial) check_ideal(curve);
  }
  SECTION("references sampled") {
    const Snapshot s = ideal_gas(12000, Vec3(10, 10, 10), {true, false, true}, 3);
    const auto d = pair_distribution(s, whole(s), s.type, 2, 0.2, 25);
    CHECK(d.particles == 12000);
    CHECK(d.references < 4000);
    CHECK(d.references > 1000);
    check_ideal(d.total);
    for (const PairCurve& curve : d.partial) check_ideal(curve);
  }
}

TEST_CASE("an ideal gas as a bed in a box with walls, and in a prism, by the measure") {
  Snapshot s = ideal_gas(20000, Vec3(20, 20, 30), {false, false, false}, 6);
  s.boundaries = {{"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}};
  SECTION("box") {
    for (int k = 0; k < 2; ++k) {
      s.boundaries.push_back({"low", "plane", Vec3::Zero(), Vec3::Unit(k)});
      s.boundaries.push_back({"high", "plane", Vec3::Constant(20), -Vec3::Unit(k)});
    }
  }
  SECTION("prism") {
    s.boundaries.push_back(prism(24, Vec3(10, 10, 0), 10, 0, 30));
    Snapshot inside = empty_box(s.domain.max, s.domain.periodic);
    inside.boundaries = s.boundaries;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (std::hypot(s.position[i].x() - 10, s.position[i].y() - 10) < 9.9) {
        add_particle(inside, s.position[i], 0.5, s.type[i]);
      }
    }
    s = inside;
  }
  const auto result = measured(s, "structure", {.rdf_range = 4, .rdf_bin = 0.1});
  const auto curve_of = [&](const std::vector<std::vector<double>>& rows, std::size_t column, auto&& chosen) {
    PairCurve curve;
    for (const auto& row : rows) {
      if (!chosen(row)) continue;
      curve.g.push_back(row[column]);
      curve.error.push_back(row[column + 1]);
    }
    return curve;
  };
  const auto total = curve_of(result.table("rdf")->rows, 2, [](const auto&) { return true; });
  REQUIRE(total.g.size() == 40);
  check_ideal(total);
  for (const auto& [a, b] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}}) {
    const auto partial = curve_of(result.table("rdf_by_types")->rows, 4,
                                  [a = a, b = b](const auto& row) { return row[0] == a && row[1] == b; });
    REQUIRE(partial.g.size() == 40);
    check_ideal(partial);
  }
}

TEST_CASE("the radial distribution function is the sum over all pairs") {
  Snapshot s = ideal_gas(400, Vec3(6, 7, 8), {false, true, false}, 9);
  const Window window{Vec3(0.5, 0, 1), Vec3(5.5, 7, 7.5), {false, true, false}};
  const double bin = 0.25;
  const auto d = pair_distribution(s, window, s.type, 2, bin, 10);
  std::size_t curve = 0;
  for (const auto& [a, b] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}}) {
    for (const std::size_t k : {2, 9}) {
      const double lower = bin * static_cast<double>(k);
      // Random directions: 256 from each of 120 particles and more, 0.3 % a share.
      CHECK(d.partial[curve].g[k] == Approx(brute_g(s, window, a, b, lower, lower + bin)).epsilon(0.02));
    }
    ++curve;
  }
}

TEST_CASE("shells of a lattice hold their neighbours, by types") {
  // Rock salt: every neighbour along an edge of the other type.
  Snapshot s = lattice(simple_cubic, 6, 6, 6, 2.0, 1.0);
  label(s, [](int x, int y, int z) { return (x + y + z) % 2; });
  const double bin = 0.1;
  const auto d = pair_distribution(s, whole(s), s.type, 2, bin, 60);
  const double volume = 12 * 12 * 12, n = 216;
  const auto neighbours = [&](const PairCurve& curve, double r, double others) {
    const auto k = static_cast<std::size_t>(r / bin);
    return curve.g[k] * shell(static_cast<double>(k) * bin, static_cast<double>(k + 1) * bin) * others / volume;
  };
  const double edge = 2.0 + 1e-6, diagonal = 2 * std::sqrt(2.0), space = 2 * std::sqrt(3.0);
  CHECK(neighbours(d.total, edge, n - 1) == Approx(6));
  CHECK(neighbours(d.total, diagonal, n - 1) == Approx(12));
  CHECK(neighbours(d.total, space, n - 1) == Approx(8));
  CHECK(neighbours(d.partial[0], edge, n / 2 - 1) == 0);
  CHECK(neighbours(d.partial[1], edge, n / 2) == Approx(6));
  CHECK(neighbours(d.partial[0], diagonal, n / 2 - 1) == Approx(12));
  CHECK(neighbours(d.partial[1], diagonal, n / 2) == 0);
  CHECK(neighbours(d.partial[2], diagonal, n / 2 - 1) == Approx(12));
  const double filled = std::accumulate(d.total.g.begin(), d.total.g.begin() + 20, 0.0);
  CHECK(filled == 0);  // nothing nearer than an edge

  const auto result = measured(s, "structure");
  CHECK(value(result, "rdf_peak_distance") == Approx(2.85));  // twelve in the shell of the diagonal
  CHECK(*result.quantity("rdf_peak_distance")->uncertainty == Approx(0.1 / std::sqrt(12.0)));
  CHECK(result.table("rdf")->rows.back()[1] == Approx(6));  // half of the box: nearer than five diameters
}

TEST_CASE("a radial distribution function that cannot be") {
  Snapshot s = ideal_gas(100, Vec3(20, 20, 20), {true, true, true}, 1);
  CHECK_THROWS_AS(measured(s, "structure", {.rdf_range = 10, .rdf_bin = 1e-5}), InputError);
  CHECK_THROWS_AS(measured(s, "structure", {.rdf_range = -1}), InputError);
  CHECK_THROWS_AS(measured(s, "structure", {.rdf_bin = INFINITY}), InputError);
  const auto coarse = measured(s, "structure", {.rdf_range = 1, .rdf_bin = 2});
  CHECK(coarse.quantity("rdf_peak")->note == "the window of the bulk is too small");
  CHECK(coarse.table("rdf")->rows.empty());
  s.radius.assign(s.size(), 0.0);
  CHECK(measured(s, "structure").quantity("rdf_peak")->note == "all radii are 0");
}

TEST_CASE("more than ten types have no curves by types") {
  Snapshot s = ideal_gas(500, Vec3(10, 10, 10), {true, true, true}, 1);
  s.groups.assign(11, s.groups.front());
  for (std::size_t i = 0; i < s.size(); ++i) s.type[i] = static_cast<int>(i % 11);
  const auto result = measured(s, "structure");
  CHECK(result.table("rdf_by_types")->rows.empty());
  CHECK(result.table("rdf_by_types")->caption.find("more than 10 types") != std::string::npos);
  CHECK_FALSE(result.table("rdf")->rows.empty());
}
