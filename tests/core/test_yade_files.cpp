// Text that Yade exported gives the numbers that its own deck printed (tests/data/yade).
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/formats/packing_series.hpp"
#include "tests/yade_bed.hpp"

using namespace packstone;
using namespace packstone::testing;
using Catch::Matchers::Contains;

namespace {

constexpr int digits = 6;  // of Yade's %g

/// Yade writes spheres in the order of their ids; without ids in the file, rows are counted from 0.
void check_spheres(const Snapshot& s, bool has_ids) {
  const auto exact = yade_particles();
  REQUIRE(s.size() == exact.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    const NamedRow& row =
        has_ids ? exact.at(s.id[i]) : std::next(exact.begin(), static_cast<std::ptrdiff_t>(s.id[i]))->second;
    CHECK(printed_as(s.position[i], vector_in(row, "x", "y", "z"), digits));
    CHECK(printed_as(s.radius[i], row.at("radius"), digits));
  }
}

}  // namespace

TEST_CASE("Yade's text has the places and radii that Yade prints") {
  check_spheres(read_packing(yade_folder / "bed.txt"), false);
  check_spheres(read_packing(yade_folder / "bed_material.txt"), false);
  check_spheres(read_packing(yade_folder / "bed_id.txt"), true);
  check_spheres(read_packing(yade_folder / "bed_attrs.txt"), false);
}

TEST_CASE("Yade's materials are types") {
  const auto exact = yade_particles();
  const Snapshot s = read_packing(yade_folder / "bed_id.txt");
  REQUIRE(s.groups.size() == 2);
  for (std::size_t i = 0; i < s.size(); ++i) CHECK(s.type[i] == exact.at(s.id[i]).at("material"));
}

TEST_CASE("attributes of Yade's text are what its comment calls them") {
  const auto exact = yade_particles();
  const Snapshot s = read_packing(yade_folder / "bed_attrs.txt");
  REQUIRE(s.fields.count("velocity") == 1);
  REQUIRE(s.fields.count("mass") == 1);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const NamedRow& row = std::next(exact.begin(), static_cast<std::ptrdiff_t>(s.id[i]))->second;
    CHECK(printed_as(Vec3(&s.fields.at("velocity").values[3 * i]), vector_in(row, "vx", "vy", "vz"), digits));
    CHECK(printed_as(s.fields.at("mass").values[i], row.at("mass"), digits));
  }
}
