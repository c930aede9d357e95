// The same bed as LAMMPS, as LIGGGHTS and as a data file describe it gives the same numbers.
// tests/data/peers has the decks that made the files.
#include <cmath>

#include <catch2/catch.hpp>

#include "analysis/forces/force_network.hpp"
#include "core/formats/packing_output.hpp"
#include "core/formats/packing_series.hpp"
#include "core/geometry.hpp"
#include "fixtures.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;

namespace {

const std::filesystem::path peers = PACKSTONE_SOURCE_DIR "/tests/data/peers";
constexpr double stiffness = 1e4, damping = 40;  // of the decks [N/m, 1/s]
const std::string counts_in_bins = "rdf_peak";   // jumps where the last digit of a dump takes a pair to the next bin

Snapshot lammps() { return read_packing(peers / "lammps.dump"); }
Snapshot liggghts() { return PackingSeries({peers / "liggghts.dump"}).snapshot(0); }

/// Gravity is not in any of the files; up is +z without.
void check_same_measures(const Snapshot& a, const Snapshot& b, const std::string& measure) {
  const auto one = fixtures::measured(a, measure), other = fixtures::measured(b, measure);
  REQUIRE(one.quantities.size() == other.quantities.size());
  for (std::size_t k = 0; k < one.quantities.size(); ++k) {
    CAPTURE(measure, one.quantities[k].key);
    REQUIRE(one.quantities[k].value.has_value() == other.quantities[k].value.has_value());
    if (!one.quantities[k].value || one.quantities[k].key == counts_in_bins) continue;
    CHECK(*one.quantities[k].value == Approx(*other.quantities[k].value).epsilon(1e-9).margin(1e-12));
  }
}

}  // namespace

TEST_CASE("dumps of LAMMPS and LIGGGHTS give the numbers of the snapshot of the same particles") {
  const testing::TemporaryFolder folder;
  Snapshot data = read_packing(peers / "bed.data");
  data.domain.periodic = {true, true, false};  // as the decks say
  write_packing(folder / "bed.vtkhdf", data);
  const Snapshot own = read_packing(folder / "bed.vtkhdf");
  REQUIRE(own.size() == 45);
  for (const char* measure : {"packing", "structure"}) {
    Snapshot one = lammps(), other = liggghts();
    CHECK(one.contacts->size() == 21);
    CHECK(other.contacts->size() == 21);
    one.contacts.reset();  // as the data file, which has none
    other.contacts.reset();
    check_same_measures(one, own, measure);
    check_same_measures(other, own, measure);
  }
  CHECK(analysis::contact_network(own).pairs.size() == 21);
}

TEST_CASE("contacts of LAMMPS and LIGGGHTS carry the same forces") {
  const Snapshot one = lammps(), other = liggghts();
  check_same_measures(one, other, "forces");
  const auto forces = fixtures::measured(one, "forces");
  CHECK(fixtures::value(forces, "normal_force_mean") > 0);
  const auto* sliding = forces.quantity("sliding_share");
  CHECK_FALSE(sliding->value);
  CHECK_THAT(sliding->note, Contains("does not say which contacts slide"));
}

TEST_CASE("forces of the dumps are those of the decks' law at the snapshot's overlaps and velocities") {
  for (const Snapshot& s : {lammps(), liggghts()}) {
    const auto row = s.rows_by_id();
    const auto velocity = [&](std::size_t i) { return Vec3(&s.fields.at("velocity").values[3 * i]); };
    for (std::size_t k = 0; k < s.contacts->size(); ++k) {
      const std::size_t i = row.at(s.contacts->first[k]), j = row.at(s.contacts->second[k]);
      const double mass = s.mass(i) * s.mass(j) / (s.mass(i) + s.mass(j));
      const Vec3 normal = s.contacts->normal[k];
      const double approach = -normal.dot(velocity(i) - velocity(j));
      const Vec3 expected = (stiffness * s.contacts->overlap[k] + damping * mass * approach) * normal;
      CHECK((s.contacts->force[k] - expected).norm() < 1e-9);
    }
  }
}

TEST_CASE("contacts with LIGGGHTS' walls count as those of a snapshot") {
  const Snapshot read = read_packing(PACKSTONE_SOURCE_DIR "/tests/data/liggghts_walls/bed.dump");
  constexpr double pairs = 61, walls = 35, particles = 36;  // as the files of LIGGGHTS count
  const auto structure = fixtures::measured(read, "structure");
  CHECK(fixtures::value(structure, "contact_count") == pairs);
  CHECK(fixtures::value(structure, "wall_contact_count") == walls);
  CHECK(fixtures::value(structure, "coordination_with_walls") == Approx((2 * pairs + walls) / particles));
  const testing::TemporaryFolder folder;
  write_packing(folder / "bed.vtkhdf", read);
  const Snapshot own = read_packing(folder / "bed.vtkhdf");
  for (const char* measure : {"packing", "structure", "forces"}) check_same_measures(read, own, measure);
}

TEST_CASE("stress of LIGGGHTS' bed is that of its weight and of its walls' forces") {
  // Virial: what contacts carry along their branches, gravity and the walls do along the heights, less what moves the
  // particles, which the dump tells.
  const Snapshot s = read_packing(PACKSTONE_SOURCE_DIR "/tests/data/liggghts_walls/bed.dump");
  constexpr double gravity = 9.8;  // of the deck [m/s2]
  double expected = 0, virial = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double moving = s.fields.at("force").values[3 * i + 2];
    expected += (s.fields.at("mass").values[i] * gravity + moving) * s.position[i].z();
  }
  const auto network = analysis::force_network(s);
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    const Vec3& force = s.contacts->force[k];
    virial += network.contacts[k].branch.z() * force.z();
    if (network.contacts[k].at_wall()) expected -= s.contacts->point[k].z() * force.z();
  }
  CHECK(virial == Approx(expected).epsilon(1e-12));
}

TEST_CASE("a series of LIGGGHTS keeps its instants, each with its contacts") {
  PackingOptions options;
  options.time_step = 2e-5;
  const PackingSeries series({peers / "liggghts.dump"}, options);
  REQUIRE(series.size() == 3);
  CHECK(series.time(1) == Approx(2e-4));
  CHECK(series.time(2) == Approx(4e-4));
  for (std::size_t k = 0; k < series.size(); ++k) CHECK(series.snapshot(k).contacts->size() > 0);
  CHECK(series.snapshot(0).position[0] != series.snapshot(2).position[0]);
}

TEST_CASE("masses of the dump are the densities of the deck") {
  const Snapshot s = lammps();
  CHECK(s.groups.at(0).density == Approx(1200).epsilon(1e-12));
  CHECK(s.groups.at(1).density == Approx(7800).epsilon(1e-12));
}

TEST_CASE("without densities, numbers that weigh do not apply") {
  Snapshot s = fixtures::cubic_bed(2, 2, 2);
  s.fields["velocity"] = {3, "m/s", std::vector<double>(3 * s.size(), 1.0)};
  s.groups[0].density = s.groups[1].density = 0;
  const auto time = fixtures::measured(s, "time"), clusters = fixtures::measured(s, "clusters");
  CHECK_FALSE(time.quantity("kinetic_energy_ratio")->value);
  CHECK_THAT(time.quantity("kinetic_energy_ratio")->note, Contains("density"));
  CHECK_FALSE(clusters.quantity("mean_size_by_mass")->value);
  CHECK_THAT(clusters.quantity("mean_size_by_mass")->note, Contains("density"));
  CHECK(time.quantity("mean_speed")->value.has_value());
  // One unknown density among known ones would weigh its particles as nothing.
  s.groups[0].density = 1000;
  s.type[0] = 1;
  CHECK_FALSE(fixtures::measured(s, "time").quantity("kinetic_energy_ratio")->value);
  CHECK_FALSE(fixtures::measured(s, "clusters").quantity("mean_size_by_mass")->value);
}
