// Periodic lattices: fraction and coordination number known exactly.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;

namespace {

struct Case {
  std::vector<Vec3> basis;
  double radius;  // touching, edge 1
  double fraction;
  int coordination;
};

}  // namespace

TEST_CASE("cubic lattices have their fractions and coordination numbers") {
  const double pi = std::numbers::pi;
  const auto c =
      GENERATE_COPY(Case{simple_cubic, 0.5, pi / 6, 6}, Case{body_centred, std::sqrt(3) / 4, std::sqrt(3) * pi / 8, 8},
                    Case{face_centred, std::sqrt(2) / 4, std::sqrt(2) * pi / 6, 12});
  Snapshot s = lattice(c.basis, 4, 5, 6, 1.0, c.radius * (1 + 1e-9));
  const auto packing = measured(s, "packing");
  CHECK(value(packing, "bulk_fraction") == Approx(c.fraction).epsilon(1e-8));
  CHECK_FALSE(packing.quantity("bed_height")->value);
  CHECK_FALSE(packing.quantity("bed_height")->note.empty());

  const auto structure = measured(s, "structure");
  CHECK(value(structure, "coordination_mean") == c.coordination);
  CHECK(value(structure, "coordination_with_walls") == c.coordination);
  CHECK(value(structure, "coordination_without_rattlers") == c.coordination);
  CHECK(value(structure, "rattler_fraction") == 0);
  CHECK(structure.quantity("coordination_mean")->uncertainty.value() == Approx(0).margin(1e-12));
  CHECK_FALSE(structure.quantity("coordination_mean")->note.empty());  // rebuilt from geometry

  const auto& rows = structure.table("coordination_distribution")->rows;
  REQUIRE(rows.size() == static_cast<std::size_t>(c.coordination) + 1);
  CHECK(rows.back()[2] == 1);
}

TEST_CASE("a periodic profile of a lattice repeats") {
  const Snapshot s = lattice(simple_cubic, 3, 3, 4, 2.0, 1.0);
  const auto packing = measured(s, "packing", {.profile_layer = 2});
  for (const auto& row : packing.table("profile")->rows) CHECK(row[2] == Approx(std::numbers::pi / 6));
}

TEST_CASE("rattlers are removed until none is left") {
  Snapshot s = lattice(simple_cubic, 3, 3, 3, 2.0, 1 + 5e-7);
  const std::size_t stable = s.size();
  s.domain.max.z() = 40;
  s.domain.periodic[2] = false;
  s.boundaries = {{"floor", "plane", Vec3(0, 0, 1e-7), Vec3::UnitZ()}};
  // A chain on the top: each link has at most two contacts.
  for (int k = 0; k < 4; ++k) add_particle(s, Vec3(1, 1, 7 + 2 * k), 1 + 5e-7);
  const auto structure = measured(s, "structure");
  CHECK(value(structure, "rattler_fraction") == Approx(4.0 / static_cast<double>(stable + 4)));
  // 27 spheres: 4 sideways each, 18 vertical pairs.
  CHECK(value(structure, "coordination_without_rattlers") == Approx((27 * 4 + 2 * 18) / 27.0));
  CHECK(value(structure, "wall_contact_count") == 9);
  CHECK(value(structure, "contact_count") == 54 + 18 + 4);
}
