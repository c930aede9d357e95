// Files of VTK that Yade wrote give the numbers that its own deck printed (tests/data/yade).
#include <algorithm>

#include <catch2/catch.hpp>

#include "core/formats/packing_series.hpp"
#include "tests/yade_bed.hpp"

using namespace packstone;
using namespace packstone::testing;

namespace {

constexpr double float_rounding = 6e-8;  // VTKRecorder writes points with 24 bits
constexpr int digits = 6;                // VTKExporter's %g

Vec3 component(const Snapshot& s, const char* field, std::size_t row) {
  return Vec3(&s.fields.at(field).values[3 * row]);
}

/// The same pairs as Yade's, and the two of each as Yade orders them.
void check_pairs(const Snapshot& s) {
  REQUIRE(s.contacts);
  const auto exact = yade_contacts();
  CHECK(s.contacts->size() == exact.size());
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    CHECK(exact.count({s.contacts->first[k], s.contacts->second[k]}) == 1);
  }
}

Vec3 force_on_first(const NamedRow& row) {
  return -vector_in(row, "fx", "fy", "fz") - vector_in(row, "ftx", "fty", "ftz");
}

}  // namespace

TEST_CASE("spheres of Yade's VTKRecorder") {
  const Snapshot s = read_packing(yade_folder / "bed-spheres.60000.vtu");
  const auto exact = yade_particles();
  REQUIRE(s.size() == exact.size());
  REQUIRE(s.groups.size() == 2);
  CHECK(s.groups[0].density == Approx(1200).epsilon(1e-12));
  CHECK(s.groups[1].density == Approx(7800).epsilon(1e-12));
  for (std::size_t i = 0; i < s.size(); ++i) {
    const NamedRow& row = exact.at(s.id[i]);
    const Vec3 place = vector_in(row, "x", "y", "z");
    CHECK((s.position[i] - place).cwiseAbs().maxCoeff() <= float_rounding * place.cwiseAbs().maxCoeff());
    CHECK(s.radius[i] == row.at("radius"));
    CHECK(s.type[i] == row.at("material"));
    CHECK(s.fields.at("mass").values[i] == row.at("mass"));
    CHECK(component(s, "velocity", i) == vector_in(row, "vx", "vy", "vz"));
    CHECK(component(s, "angular_velocity", i) == vector_in(row, "wx", "wy", "wz"));
    CHECK(component(s, "force", i) == vector_in(row, "fx", "fy", "fz"));
  }
}

TEST_CASE("interactions of Yade's VTKRecorder are normal forces between spheres") {
  const Snapshot s = read_packing(yade_folder / "bed-spheres.60000.vtu");
  check_pairs(s);
  const auto exact = yade_contacts();
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    const NamedRow& row = exact.at({s.contacts->first[k], s.contacts->second[k]});
    const Vec3 force = -vector_in(row, "fx", "fy", "fz");
    CHECK((s.contacts->force[k] - force).norm() < 2e-6 * force.norm());  // the direction is that of rounded points
    CHECK((s.contacts->normal[k] + vector_in(row, "nx", "ny", "nz")).norm() < 2e-6);
    CHECK(s.contacts->overlap[k] == Approx(row.at("overlap")).margin(3e-8));
  }
  CHECK(std::any_of(s.notes.begin(), s.notes.end(),
                    [](const std::string& note) { return note.find("friction's direction") != std::string::npos; }));
}

TEST_CASE("spheres of Yade's VTKExporter") {
  const Snapshot s = read_packing(yade_folder / "bed-spheres-00000000.vtk");
  const auto exact = yade_particles();
  REQUIRE(s.size() == exact.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    const NamedRow& row = exact.at(s.id[i]);
    CHECK(printed_as(s.position[i], vector_in(row, "x", "y", "z"), digits));
    CHECK(printed_as(s.radius[i], row.at("radius"), digits));
    CHECK(s.type[i] == row.at("material"));
    CHECK(printed_as(s.fields.at("mass").values[i], row.at("mass"), digits));
    CHECK(printed_as(component(s, "velocity", i), vector_in(row, "vx", "vy", "vz"), digits));
  }
}

TEST_CASE("interactions of Yade's VTKExporter carry friction where it was asked for") {
  const Snapshot s = read_packing(yade_folder / "bed-spheres-00000000.vtk");
  check_pairs(s);
  const auto exact = yade_contacts();
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    const NamedRow& row = exact.at({s.contacts->first[k], s.contacts->second[k]});
    const Vec3 force = force_on_first(row);
    CHECK((s.contacts->force[k] - force).norm() < 1e-5 * force.norm());
    CHECK(s.contacts->overlap[k] > 0);
    CHECK(s.contacts->overlap[k] == Approx(row.at("overlap")).margin(4e-7));  // places are printed with six digits
  }
  CHECK(std::none_of(s.notes.begin(), s.notes.end(),
                     [](const std::string& note) { return note.find("friction's direction") != std::string::npos; }));
}
