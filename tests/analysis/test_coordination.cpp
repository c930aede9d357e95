// Coordination numbers by kind, and the fabric of the contacts.
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/analysis/random_packings.hpp"

using namespace packstone;
using namespace packstone::fixtures;

namespace {

/// Touching pairs far from each other, each along a given direction, their middles at a height.
void add_pairs(Snapshot& s, const std::vector<Vec3>& directions, double height) {
  const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(directions.size()))));
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Vec3 middle(2 + 4.0 * static_cast<double>(k % side), 2 + 4.0 * static_cast<double>(k / side), height);
    for (const double sign : {-1.0, 1.0}) add_particle(s, middle + sign * 0.499 * directions[k], 0.5);
  }
}

Snapshot pairs_at(const std::vector<Vec3>& directions) {
  Snapshot s = empty_box(Vec3(1000, 1000, 10), {true, true, true});
  add_pairs(s, directions, 5);
  return s;
}

const std::vector<double>& row_of(const analysis::MeasureResult& result, const std::string& table, std::size_t row) {
  return result.table(table)->rows.at(row);
}

}  // namespace

TEST_CASE("contacts by types of a layered and of a chequered lattice") {
  Snapshot s = lattice(simple_cubic, 4, 4, 4, 2.0, 1 + 5e-7);
  SECTION("a column of another type") {
    label(s, [](int x, int y, int) { return x == 0 && y == 0 ? 1 : 0; });
    const auto result = measured(s, "structure");
    const auto& rows = result.table("coordination_by_types")->rows;
    REQUIRE(rows.size() == 4);
    // 60 of type 0, of which 16 touch the column once; 4 of type 1 with two neighbours of their own.
    CHECK(rows[0][2] == 60);
    CHECK(rows[0][3] == Approx(5 + 44.0 / 60));
    CHECK(rows[1][3] == Approx(16.0 / 60));
    CHECK(rows[2][3] == Approx(4));
    CHECK(rows[3][3] == Approx(2));
    const double p = 16.0 / 60;  // share with one contact, the others with none
    CHECK(rows[1][4] == Approx(std::sqrt(p * (1 - p) / 59)));
    CHECK(rows[2][4] == Approx(0).margin(1e-12));
  }
  SECTION("chequered") {
    label(s, [](int x, int y, int z) { return (x + y + z) % 2; });
    const auto result = measured(s, "structure");
    const auto& rows = result.table("coordination_by_types")->rows;
    REQUIRE(rows.size() == 4);
    CHECK(rows[0][3] == 0);
    CHECK(rows[1][3] == 6);
    CHECK(rows[2][3] == 6);
    CHECK(rows[3][3] == 0);
  }
  SECTION("one particle of its type has no error") {
    s.type[5] = 1;
    CHECK(std::isnan(row_of(measured(s, "structure"), "coordination_by_types", 2)[4]));
  }
}

TEST_CASE("the distribution of contacts with walls and without rattlers") {
  Snapshot s = cubic_bed(3, 3, 3);
  s.boundaries = {{"floor", "plane", Vec3(0, 0, 1e-7), Vec3::UnitZ()}};
  s.domain.max.z() = 20;
  add_particle(s, Vec3(1, 1, 7), 1 + 5e-7);  // on top: a rattler
  const auto result = measured(s, "structure");
  const auto& rows = result.table("coordination_distribution")->rows;
  REQUIRE(rows.size() == 7);
  const auto column = [&](std::size_t c) {
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row[c]);
    return values;
  };
  // Floor and top layers 5 contacts, the middle 6, one top sphere the rattler besides.
  CHECK(column(1) == std::vector<double>{0, 1, 0, 0, 0, 17, 10});
  CHECK(column(3) == std::vector<double>{0, 1, 0, 0, 0, 8, 19});
  CHECK(column(5) == std::vector<double>{0, 0, 0, 0, 0, 18, 9});
  CHECK(rows[6][2] == Approx(10.0 / 28));
  CHECK(rows[6][4] == Approx(19.0 / 28));
  CHECK(rows[6][6] == Approx(9.0 / 27));
  CHECK(value(result, "coordination_without_rattlers") == Approx((18 * 5 + 9 * 6) / 27.0));
  CHECK(*result.quantity("coordination_without_rattlers")->uncertainty == Approx(std::sqrt(18 * 9 / 27.0 / 26 / 27)));
}

TEST_CASE("the fabric of lattices and of pairs along one axis") {
  SECTION("simple cubic: isotropic to second order") {
    const auto result = measured(lattice(simple_cubic, 4, 4, 4, 2.0, 1 + 5e-7), "structure");
    CHECK(value(result, "fabric_anisotropy") == Approx(0).margin(1e-12));
    CHECK(value(result, "fabric_vertical") == Approx(1.0 / 3));
    CHECK(value(result, "fabric_anisotropy_random") == Approx(7.5 / std::sqrt(3 * 64)));
    for (std::size_t c = 8; c < 11; ++c) CHECK(row_of(result, "fabric", 0)[c] == Approx(1.0 / 3));
  }
  SECTION("all contacts along one slanted axis") {
    const Vec3 axis = Vec3(1, 2, -2) / 3;
    const auto result = measured(pairs_at({axis, axis, axis}), "structure");
    // F = 15/2 diag(2/3, -1/3, -1/3): sqrt(3/2 F:F) = 7.5.
    CHECK(value(result, "fabric_anisotropy") == Approx(7.5));
    CHECK(*result.quantity("fabric_anisotropy")->uncertainty == Approx(0).margin(1e-7));
    CHECK(value(result, "fabric_principal_angle") == Approx(std::acos(2.0 / 3) * 180 / EIGEN_PI));
    const auto& row = row_of(result, "fabric", 1);
    CHECK(row[1] == 3);
    CHECK(row[6] == Approx(axis.x() * axis.z()));
    CHECK(row[8] == Approx(1));
    CHECK(row[13] == Approx(-1.0 / 3));  // turned upwards
    CHECK(row[15] == Approx(2.0 / 3));
  }
  SECTION("bulk and all: what lies below the bulk counts only in all") {
    Snapshot s = empty_box(Vec3(1000, 1000, 100), {true, true, false});
    for (int k = 0; k < 20; ++k) add_pairs(s, std::vector<Vec3>(4, Vec3::UnitX()), 12 + 4 * k);
    add_pairs(s, std::vector<Vec3>(40, Vec3::UnitZ()), 1);
    const auto result = measured(s, "structure");
    CHECK(row_of(result, "fabric", 0)[1] == 120);
    CHECK(row_of(result, "fabric", 0)[4] == Approx(1.0 / 3));
    CHECK(value(result, "fabric_vertical") == Approx(0).margin(1e-12));
    CHECK(value(result, "fabric_principal_angle") == Approx(90));
  }
  SECTION("none") {
    const auto result = measured(empty_box(Vec3(1, 1, 1)), "structure");
    CHECK_FALSE(result.quantity("fabric_anisotropy")->value);
    CHECK(result.table("fabric")->rows.empty());
  }
}

TEST_CASE("the anisotropy of random contacts scatters as its uncertainty says") {
  // Directions of density (1 + F_zz n_z^2 + ..)/(4 pi) by rejection; 1 + a (3 z^2 - 1)/2 has F = a diag(-1/2, -1/2, 1),
  // so the anisotropy 3/2 a.
  const double a = GENERATE(0.0, 0.8);
  Random random(7, RandomStream::filling_position, 0);
  const int repeats = 40, contacts = 200;
  double sum = 0, squares = 0, reported = 0, expected_random = 0;
  for (int r = 0; r < repeats; ++r) {
    std::vector<Vec3> directions;
    while (directions.size() < contacts) {
      const Vec3 n = random_direction(random);
      if (random.uniform(0, 1 + a) < 1 + a * (1.5 * n.z() * n.z() - 0.5)) directions.push_back(n);
    }
    const auto result = measured(pairs_at(directions), "structure");
    const double anisotropy = value(result, "fabric_anisotropy");
    sum += anisotropy / repeats;
    squares += anisotropy * anisotropy / repeats;
    reported += *result.quantity("fabric_anisotropy")->uncertainty / repeats;
    expected_random = value(result, "fabric_anisotropy_random");
  }
  const double scatter = std::sqrt(squares - sum * sum);
  if (a == 0) {
    CHECK(std::sqrt(squares) == Approx(expected_random).epsilon(0.2));  // 40 x 5 normal numbers: 5 % at 1 sigma
  } else {
    // The four other components of the deviator add their random part in quadrature.
    CHECK(sum ==
          Approx(1.5 * a).margin(4 * scatter / std::sqrt(repeats) + expected_random * expected_random / (3 * a)));
    CHECK(reported == Approx(scatter).epsilon(0.4));  // 11 % at 1 sigma
  }
}
