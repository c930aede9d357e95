// Bond-orientational order: harmonics, neighbours, lattices, an ideal gas.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "analysis/structure/bond_order.hpp"
#include "analysis/structure/harmonics.hpp"
#include "core/error.hpp"
#include "tests/analysis/random_packings.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

/// P_4 and P_6.
double legendre(int l, double x) {
  const double y = x * x;
  return l == 4 ? ((35 * y - 30) * y + 3) / 8 : (((231 * y - 315) * y + 105) * y - 5) / 16;
}

/// q_l of one particle without harmonics: q_l^2 = sum_jk P_l(n_j . n_k)/n^2, by the addition theorem.
double brute_q(int l, const std::vector<Vec3>& directions) {
  double sum = 0;
  for (const Vec3& a : directions) {
    for (const Vec3& b : directions) sum += legendre(l, std::clamp(a.dot(b), -1.0, 1.0));
  }
  return std::sqrt(sum) / static_cast<double>(directions.size());
}

/// Hexagonal close packing of spheres of diameter 1, four to a cell of 1 x sqrt(3) x sqrt(8/3).
Snapshot hexagonal(int nx, int ny, int nz) {
  const Vec3 cell(1, std::sqrt(3.0), std::sqrt(8.0 / 3));
  Snapshot s = empty_box(cell.cwiseProduct(Vec3(nx, ny, nz)), {true, true, true});
  const std::vector<Vec3> basis = {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 1.0 / 6, 0.5), Vec3(0, 4.0 / 6, 0.5)};
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) {
        for (const Vec3& b : basis) add_particle(s, (Vec3(i, j, k) + b).cwiseProduct(cell), 0.5);
      }
    }
  }
  return s;
}

/// Neighbours of every particle by looking at all.
std::vector<std::vector<std::uint32_t>> brute_bonds(const Snapshot& s, double factor) {
  std::vector<std::vector<std::uint32_t>> lists(s.size());
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    for (std::uint32_t j = 0; j < s.size(); ++j) {
      const double distance = s.domain.separation(s.position[i], s.position[j]).norm();
      if (i != j && distance < factor * (s.radius[i] + s.radius[j])) lists[i].push_back(j);
    }
  }
  return lists;
}

std::vector<std::uint32_t> sorted(std::span<const std::uint32_t> list) {
  std::vector<std::uint32_t> result(list.begin(), list.end());
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

TEST_CASE("the harmonics are those of the standard library, and obey the addition theorem") {
  const HarmonicsRecurrence recurrence;
  Random random(3, RandomStream::filling_position, 0);
  std::vector<Vec3> directions = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitZ()};
  for (int k = 0; k < 30; ++k) directions.push_back(random_direction(random));
  Harmonics before{};
  Vec3 last = Vec3::UnitX();
  recurrence.add(last, before);
  for (const Vec3& n : directions) {
    Harmonics h{};
    recurrence.add(n, h);
    const double theta = std::acos(std::clamp(n.z(), -1.0, 1.0)), phi = std::atan2(n.y(), n.x());
    for (const int l : {4, 6}) {
      const double* values = h.data() + (l == 4 ? 0 : harmonics_of_4);
      const double factor = std::sqrt(4 * EIGEN_PI / (2 * l + 1));
      for (int m = 0; m <= l; ++m) {
        // std::sph_legendre keeps Condon and Shortley's sign.
        const double y = factor * std::sph_legendre(static_cast<unsigned>(l), static_cast<unsigned>(m), theta) *
                         (m % 2 == 0 ? 1 : -1) * (m == 0 ? 1 : std::sqrt(2.0));
        CHECK(values[m == 0 ? 0 : 2 * m - 1] == Approx(y * std::cos(m * phi)).margin(1e-13));
        if (m > 0) CHECK(values[2 * m] == Approx(y * std::sin(m * phi)).margin(1e-13));
      }
    }
    CHECK(product_of_4(h, before) == Approx(legendre(4, n.dot(last))).margin(1e-13));
    CHECK(product_of_6(h, before) == Approx(legendre(6, n.dot(last))).margin(1e-13));
    before = h;
    last = n;
  }
}

TEST_CASE("lattices have the bond order of the literature") {
  struct Case {
    Snapshot snapshot;
    double neighbours, q4, q6, crystalline;
  };
  // Squares of the cubic values are rational: Steinhardt et al. (1983), and by hand from P_4, P_6.
  const auto c = GENERATE(
      Case{lattice(simple_cubic, 4, 4, 4, 1.0, 0.5), 6, std::sqrt(7.0 / 12), std::sqrt(1.0 / 8), 0},
      Case{lattice(face_centred, 3, 3, 3, 1.0, std::sqrt(2) / 4), 12, std::sqrt(7.0 / 192), std::sqrt(169.0 / 512), 1},
      Case{lattice(body_centred, 4, 4, 4, 1.0, std::sqrt(3) / 4), 14, 0.036369648, 0.510688231, 1},
      Case{hexagonal(4, 3, 3), 12, 7.0 / 72, 0.484761685, 1});
  const auto result = measured(c.snapshot, "structure");
  CHECK(value(result, "bond_neighbours_mean") == c.neighbours);
  CHECK(value(result, "q4_mean") == Approx(c.q4).margin(2e-9));
  CHECK(value(result, "q6_mean") == Approx(c.q6).margin(2e-9));
  CHECK(*result.quantity("q6_mean")->uncertainty == Approx(0).margin(1e-9));
  CHECK(value(result, "crystalline_fraction") == c.crystalline);
  double share = 0;
  for (const auto& row : result.table("bond_order_distribution")->rows) {
    share += row[3];
    if (row[0] <= c.q6 && c.q6 < row[1]) CHECK(row[3] == Approx(1));
  }
  CHECK(share == Approx(1));
}

TEST_CASE("all sites of a cubic lattice agree: averaged and global order are the local one") {
  const auto result = measured(lattice(face_centred, 3, 4, 3, 1.0, std::sqrt(2) / 4), "structure");
  for (const char* key : {"q6_averaged_mean", "q6_global"}) CHECK(value(result, key) == Approx(std::sqrt(169.0 / 512)));
  for (const char* key : {"q4_averaged_mean", "q4_global"}) CHECK(value(result, key) == Approx(std::sqrt(7.0 / 192)));
}

TEST_CASE("the order of a random packing by pairs of bonds, turned in space") {
  Snapshot s = ideal_gas(300, Vec3(7, 7, 7), {false, false, false}, 5);
  const Eigen::AngleAxisd turn(1.1, Vec3(1, -2, 0.5).normalized());
  if (GENERATE(false, true)) {
    for (Vec3& p : s.position) p = turn * p;
  }
  const auto lists = brute_bonds(s, 1.3);
  std::vector<char> chosen(s.size(), 1);
  chosen[3] = 0;
  const BondOrder order = bond_order(s, bonds_within(s, 1.3), chosen);
  const auto direction = [&](std::uint32_t from, std::uint32_t to) {
    return (s.position[to] - s.position[from]).normalized().eval();
  };
  std::vector<Vec3> all;
  int solid_pairs = 0;
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    std::vector<Vec3> own;
    for (const std::uint32_t j : lists[i]) own.push_back(direction(i, j));
    if (chosen[i]) all.insert(all.end(), own.begin(), own.end());
    if (own.empty()) continue;
    CHECK(order.q4[i] == Approx(brute_q(4, own)).margin(1e-7));  // a square root of rounding near 0
    CHECK(order.q6[i] == Approx(brute_q(6, own)).margin(1e-7));
    // Averaged: sums over pairs of bonds of the particle and its neighbours, weighted by 1/number of bonds.
    std::vector<std::pair<Vec3, double>> around;
    const auto add = [&](std::uint32_t k) {
      for (const std::uint32_t j : lists[k]) {
        around.push_back({direction(k, j), 1.0 / static_cast<double>(lists[k].size())});
      }
    };
    add(i);
    for (const std::uint32_t j : lists[i]) add(j);
    if (i < 150) {
      double sum = 0;
      for (const auto& [a, wa] : around) {
        for (const auto& [b, wb] : around) sum += wa * wb * legendre(6, std::clamp(a.dot(b), -1.0, 1.0));
      }
      CHECK(order.averaged_q6[i] == Approx(std::sqrt(sum) / static_cast<double>(own.size() + 1)).margin(1e-7));
      int solid = 0;
      for (const std::uint32_t j : lists[i]) {
        double product = 0;
        for (const Vec3& a : own) {
          for (const std::uint32_t k : lists[j]) product += legendre(6, std::clamp(a.dot(direction(j, k)), -1.0, 1.0));
        }
        product /= static_cast<double>(own.size() * lists[j].size());
        solid += product > 0.7 * order.q6[i] * order.q6[j];
      }
      CHECK(order.solid_bonds[i] == solid);
      solid_pairs += solid;
    }
  }
  CHECK(solid_pairs > 10);
  CHECK(order.bond_ends == static_cast<double>(all.size()));
  CHECK(order.global_q6 == Approx(brute_q(6, all)).margin(1e-9));
  CHECK(order.global_q4 == Approx(brute_q(4, all)).margin(1e-9));
}

TEST_CASE("neighbours by cut-off and by number are those that looking at all gives") {
  const auto periodic = GENERATE(std::array{false, false, false}, std::array{true, false, true});
  Snapshot s = ideal_gas(500, Vec3(10, 9, 11), periodic, 8);
  Random random(2, RandomStream::particle_radius, 0);
  for (double& r : s.radius) r = 0.03 * std::pow(30, random.uniform());
  s.position[0] = Vec3(30, -40, 50);  // outside
  s.radius[1] = 0;
  const auto expected = brute_bonds(s, 1.4);
  const Bonds within = bonds_within(s, 1.4);
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    CHECK(sorted(within.of(i)) == expected[i]);
    found += expected[i].size();
  }
  CHECK(found > 200);

  const Bonds nearest = nearest_bonds(s, 12);
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    std::vector<std::pair<double, std::uint32_t>> others;
    for (std::uint32_t j = 0; j < s.size(); ++j) {
      if (j != i) others.push_back({s.domain.separation(s.position[i], s.position[j]).squaredNorm(), j});
    }
    std::sort(others.begin(), others.end());
    REQUIRE(nearest.of(i).size() == 12);
    for (std::size_t k = 0; k < 12; ++k) CHECK(nearest.of(i)[k] == others[k].second);
  }
  CHECK(nearest_bonds(s, 1000).of(7).size() == s.size() - 1);
}

TEST_CASE("an ideal gas: q_l of n independent bonds has the mean square 1/n") {
  const Snapshot s = ideal_gas(5000, Vec3(12, 12, 12), {true, true, true}, 4);
  const BondOrder order = bond_order(s, nearest_bonds(s, 12), std::vector<char>(s.size(), 1));
  for (const auto* values : {&order.q4, &order.q6}) {
    double mean = 0, squares = 0;
    for (const double q : *values) mean += q * q / static_cast<double>(s.size());
    for (const double q : *values) squares += (q * q - mean) * (q * q - mean);
    // Particles share bonds: their spread is wider than that of independent ones, by two at most.
    CHECK(mean == Approx(1.0 / 12).margin(4 * 2 * std::sqrt(squares) / static_cast<double>(s.size())));
  }
  const auto result = measured(s, "structure", {.bond_neighbours = 12});
  CHECK(value(result, "crystalline_fraction") < 0.01);
  CHECK(value(result, "bond_neighbours_mean") == 12);
  CHECK(value(result, "q6_global") < 4 * *result.quantity("q6_global")->uncertainty);
}

TEST_CASE("bond order where there is none, and options out of range") {
  Snapshot s = empty_box(Vec3(9, 9, 9), {true, true, true});
  add_particle(s, Vec3(1, 1, 1), 0.5);
  auto result = measured(s, "structure");
  CHECK(result.quantity("q6_mean")->note == "no particle has a neighbour");
  CHECK(value(result, "crystalline_fraction") == 0);
  add_particle(s, Vec3(1, 1, 1), 0.5);  // at the same place: no direction
  CHECK_FALSE(measured(s, "structure").quantity("q6_mean")->value);
  CHECK_FALSE(measured(s, "structure", {.bond_neighbours = 12}).quantity("q6_mean")->value);
  CHECK_THROWS_AS(measured(s, "structure", {.bond_cutoff = 0.5}), InputError);
  CHECK_THROWS_AS(measured(s, "structure", {.bond_cutoff = std::nan("")}), InputError);
  CHECK_THROWS_AS(measured(s, "structure", {.bond_neighbours = -1}), InputError);
}
