// What measures know of every particle, against the numbers and tables that the measures themselves give, and by hand.
#include <cmath>
#include <map>
#include <set>

#include <catch2/catch.hpp>
#include <omp.h>

#include "analysis/group_ranks.hpp"
#include "analysis/particle_fields.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/geometry.hpp"
#include "tests/analysis/force_fixtures.hpp"
#include "tests/analysis/random_packings.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;
using packstone::testing::TemporaryFolder;

namespace {

using Values = std::map<std::string, ParticleField>;

Values fields_of(const Snapshot& s, const std::vector<std::string>& measures, const Options& options = {}) {
  Values fields;
  for (auto& field : particle_fields(s, measures, options)) fields.emplace(field.name, field);
  return fields;
}

std::vector<std::string> measures_with_fields() {
  std::vector<std::string> names;
  for (const auto& measure : all_measures()) {
    if (measure.fields) names.push_back(measure.name);
  }
  return names;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// Overlapping spheres of two sizes and types in a periodic box, every pair pressing with a force of its own.
Snapshot pressed_gas() {
  Snapshot s = ideal_gas(600, Vec3(9, 9, 9), {true, true, true}, 3, 0.5);
  for (std::size_t i = 0; i < s.size(); ++i) s.radius[i] = i % 2 ? 0.6 : 0.4;
  Random random(8, RandomStream::filling_position, 1);
  const ContactNetwork network = contact_network(s);
  for (const NearPair& pair : network.pairs) {
    press(s, pair.first, pair.second, random.uniform(0, 2));
    s.contacts->overlap.back() = pair.overlap;
  }
  return s;
}

/// Fields must not hide which particle is which: the means and tables of the measures follow from them.
void check_same(const std::vector<double>& values, const MeasureResult& result, const std::string& key) {
  INFO(key);
  CHECK(mean(values) == Approx(value(result, key)).epsilon(1e-12));
}

}  // namespace

TEST_CASE("fields have one name each, a definition, and a value a particle or a reason") {
  const auto check = [](const Snapshot& s) {
    std::set<std::string> names;
    for (const ParticleField& field : particle_fields(s, measures_with_fields())) {
      INFO(field.name);
      CHECK(names.insert(field.name).second);
      CHECK_FALSE(field.definition.empty());
      CHECK((field.components == 1 || field.components == 3));
      CHECK(field.values.size() ==
            (field.missing.empty() ? s.size() * static_cast<std::size_t>(field.components) : std::size_t{0}));
    }
    return names;
  };
  const auto names = check(pressed_gas());
  CHECK(names.size() == 28);
  CHECK(check(cubic_bed(3, 3, 3)) == names);
  CHECK(check(empty_box(Vec3(1, 1, 1))) == names);
  CHECK(check(Snapshot{}) == names);
  CHECK(check(column(1)) == names);
  Snapshot points = column(3);
  std::fill(points.radius.begin(), points.radius.end(), 0.0);
  CHECK(check(points) == names);
  CHECK_THROWS_WITH(particle_fields(column(2), {"packing"}), Contains("those that have are voronoi, structure"));
  CHECK_THROWS_WITH(particle_fields(column(2), {"strcture"}), Contains("did you mean 'structure'"));
}

TEST_CASE("a column under its weight has the stress of its forces") {
  const int n = 5;
  const double load = 1e4;
  const Snapshot s = column(n, load);
  auto fields = fields_of(s, {"structure", "forces", "communities"});
  const double weight = s.mass(0) * 9.8, volume = sphere_volume(1);
  for (int k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double below = (n - k) * weight + load, above = below - weight;
    const double zz = (below + above) / volume;  // lever arms of 1 m
    CHECK(fields["stress_zz"].values[i] == Approx(zz).epsilon(1e-8));
    CHECK(fields["stress_major"].values[i] == Approx(zz).epsilon(1e-8));
    CHECK(fields["pressure"].values[i] == Approx(zz / 3).epsilon(1e-8));
    CHECK(fields["stress_deviator"].values[i] == Approx(zz).epsilon(1e-8));
    for (const char* name : {"stress_xx", "stress_yy", "stress_xy", "stress_xz", "stress_yz"}) {
      CHECK(fields[name].values[i] == 0);
    }
    CHECK(std::abs(fields["stress_major_direction"].values[3 * i + 2]) == 1);
    CHECK(fields["coordination"].values[i] == (k == 0 || k == n - 1 ? 1 : 2));
    CHECK(fields["coordination_with_walls"].values[i] == 2);
    CHECK(fields["rattler"].values[i] == 1);
    CHECK(fields["core"].values[i] == 1);
  }
  // With the load the lowest sphere alone is not far above the mean: all above it make the chain of the table.
  const auto links = table_column(measured(s, "forces"), "chain_links", "first");
  std::size_t in_chain = 0;
  for (const double chain : fields["chain"].values) in_chain += std::isnan(chain) ? 0 : 1;
  CHECK(in_chain == (links.empty() ? 0 : links.size() + 1));
}

TEST_CASE("shear shows in the tensor, the direction and von Mises' measure") {
  Snapshot s = empty_box(Vec3(10, 10, 10), {false, false, false});
  add_particle(s, Vec3(3, 5, 5), 1);
  add_particle(s, Vec3(5, 5, 5), 1);
  add_particle(s, Vec3(9, 9, 9), 1);
  add_contact(s, 0, 1, -Vec3::UnitX(), 6, Vec3(0, 4, 0));  // force (-6, 4, 0) on the first
  auto fields = fields_of(s, {"forces"});
  const double volume = sphere_volume(1), xx = 6 / volume, xy = -2 / volume;  // half of the moment is symmetric
  CHECK(fields["stress_xx"].values[0] == Approx(xx));
  CHECK(fields["stress_xy"].values[0] == Approx(xy));
  CHECK(fields["pressure"].values[0] == Approx(xx / 3));
  CHECK(fields["stress_deviator"].values[0] == Approx(std::sqrt(xx * xx + 3 * xy * xy)));
  const double half = xx / 2, major = half + std::hypot(half, xy);
  CHECK(fields["stress_major"].values[0] == Approx(major));
  const auto& direction = fields["stress_major_direction"].values;
  CHECK(direction[1] / direction[0] == Approx((major - xx) / xy));
  CHECK(std::hypot(direction[0], direction[1], direction[2]) == Approx(1));
  CHECK(fields["pressure"].values[2] == 0);  // touches nothing
  for (std::size_t k = 6; k < 9; ++k) CHECK(std::isnan(direction[k]));
}

TEST_CASE("fields give the means and tables of their measures") {
  const Snapshot s = pressed_gas();
  auto fields = fields_of(s, measures_with_fields(), {.clusters = {.gap = 0.05}});
  const auto structure = measured(s, "structure");
  check_same(fields["coordination"].values, structure, "coordination_mean");
  check_same(fields["coordination_with_walls"].values, structure, "coordination_with_walls");
  check_same(fields["rattler"].values, structure, "rattler_fraction");
  std::vector<double> q6, averaged, neighbours, crystalline;
  for (std::size_t i = 0; i < s.size(); ++i) {
    crystalline.push_back(fields["solid_bonds"].values[i] >= 7);
    CHECK(std::isnan(fields["q6"].values[i]) == (fields["bond_neighbours"].values[i] == 0));
    if (fields["bond_neighbours"].values[i] == 0) continue;
    q6.push_back(fields["q6"].values[i]);
    averaged.push_back(fields["q6_averaged"].values[i]);
    neighbours.push_back(fields["bond_neighbours"].values[i]);
  }
  check_same(q6, structure, "q6_mean");
  check_same(averaged, structure, "q6_averaged_mean");
  check_same(neighbours, structure, "bond_neighbours_mean");
  check_same(crystalline, structure, "crystalline_fraction");

  const auto forces = measured(s, "forces");
  check_same(fields["pressure"].values, forces, "particle_pressure_mean");
  check_same(fields["core"].values, forces, "core_mean");
  const auto chain = table_column(forces, "chain_links", "chain"), first = table_column(forces, "chain_links", "first");
  REQUIRE(chain.size() > 10);
  std::map<std::int64_t, std::size_t> row;
  for (std::size_t i = 0; i < s.size(); ++i) row[s.id[i]] = i;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    CHECK(fields["chain"].values[row[static_cast<std::int64_t>(first[k])]] == chain[k]);
  }
  double in_chains = 0;
  for (const double c : fields["chain"].values) in_chains += std::isnan(c) ? 0 : 1;
  CHECK(in_chains / static_cast<double>(s.size()) == Approx(value(forces, "chain_particle_share")));

  const auto voronoi = measured(s, "voronoi");
  std::vector<double> fraction, faces;
  double volume = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    volume += fields["voronoi_volume"].values[i];
    const bool whole = fields["voronoi_state"].values[i] == 0;  // others are empty: the gas has no surface
    CHECK(std::isnan(fields["local_fraction"].values[i]) == !whole);
    if (!whole) continue;
    fraction.push_back(fields["local_fraction"].values[i]);
    faces.push_back(fields["voronoi_faces"].values[i]);
  }
  check_same(fraction, voronoi, "local_fraction_mean");
  check_same(faces, voronoi, "faces_mean");
  CHECK(volume == Approx(9 * 9 * 9).epsilon(1e-10));

  const auto clusters = analyze(s, {"clusters"}, {.clusters = {.gap = 0.05}}).front();
  std::set<double> numbers(fields["cluster"].values.begin(), fields["cluster"].values.end());
  CHECK(static_cast<double>(numbers.size()) == value(clusters, "count"));
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (fields["cluster"].values[i] == 0) CHECK(fields["cluster_size"].values[i] == value(clusters, "largest"));
  }

  const auto communities = measured(s, "communities");
  const auto member = table_column(communities, "members", "community"),
             id = table_column(communities, "members", "id");
  for (std::size_t k = 0; k < id.size(); ++k) {
    CHECK(fields["community"].values[row[static_cast<std::int64_t>(id[k])]] == member[k]);
  }
}

TEST_CASE("groups are numbered by size, equal ones by their lowest id") {
  const std::vector<std::uint32_t> label = {5, 1, 1, 5, 2, 3, 3, 3};
  const std::vector<std::int64_t> id = {70, 60, 50, 40, 1, 9, 8, 7};
  const GroupRanks ranks = group_ranks(label, id);
  CHECK(ranks.of_particle == std::vector<std::uint32_t>{1, 2, 2, 1, 3, 0, 0, 0});
  CHECK(ranks.size == std::vector<std::uint32_t>{3, 2, 2, 1});
}

TEST_CASE("without forces the fields of stress say why, the others stay") {
  const Snapshot s = cubic_bed(3, 3, 3);
  auto fields = fields_of(s, {"forces", "communities", "clusters"}, {.clusters = {.least_force = 1}});
  for (const char* name : {"pressure", "stress_xy", "stress_major_direction", "chain", "community", "cluster"}) {
    INFO(name);
    CHECK(fields[name].missing == "the snapshot holds no contact forces");
    CHECK(fields[name].values.empty());
  }
  CHECK(fields["core"].values.size() == s.size());
  CHECK(fields["core"].missing.empty());
}

TEST_CASE("fields are the same for any number of threads") {
  const Snapshot s = pressed_gas();
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = particle_fields(s, measures_with_fields());
  omp_set_num_threads(3);
  const auto three = particle_fields(s, measures_with_fields());
  omp_set_num_threads(before);
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (std::size_t k = 0; k < one.size(); ++k) {
    INFO(one[k].name);
    CHECK(std::equal(one[k].values.begin(), one[k].values.end(), three[k].values.begin(), three[k].values.end(), same));
  }
}

TEST_CASE("particles are written with their fields, and a snapshot reads back the same") {
  const TemporaryFolder folder;
  const Snapshot s = column(4, 100);
  const auto fields = particle_fields(s, {"forces"});
  write_particles(folder / "bed.vtkhdf", s, fields);
  const Snapshot back = read_snapshot(folder / "bed.vtkhdf");
  const auto rows = back.rows_by_id();
  for (const ParticleField& field : fields) {
    INFO(field.name);
    const Field& read = back.fields.at(field.name);
    CHECK(read.unit == field.unit);
    REQUIRE(read.components == field.components);
    const auto width = static_cast<std::size_t>(field.components);
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (std::size_t k = 0; k < width; ++k) {
        const double wrote = field.values[width * i + k], found = read.values[width * rows.at(s.id[i]) + k];
        CHECK((wrote == found || (std::isnan(wrote) && std::isnan(found))));
      }
    }
  }
  // Measured again, its own fields are replaced.
  CHECK(particle_fields(back, {"forces"}).front().values.size() == s.size());
  write_particles(folder / "again.vtkhdf", back, particle_fields(back, {"forces"}));

  write_particles(folder / "bed.vtp", s, fields);
  CHECK_THAT(read_text_file(folder / "bed.vtp"), Contains("Name=\"stress_major_direction\" NumberOfComponents=\"3\""));
  CHECK_THROWS_WITH(write_particles(folder / "bed.xyz", s, fields), Contains(".vtkhdf (snapshot), .vtu, .vtp or .csv"));
  CHECK_THROWS_AS(write_particles("/proc/packstone/bed.csv", s, fields), RunError);
}

TEST_CASE("a table of particles has units in its header and empty cells where there is no value") {
  const TemporaryFolder folder;
  Snapshot s = empty_box(Vec3(4, 4, 4), {false, false, false});
  add_particle(s, Vec3(1, 2, 3), 0.5, 1);
  const std::vector<ParticleField> fields = {
      {.name = "pressure", .unit = "Pa", .definition = "-", .values = {2.5}},
      {.name = "direction", .definition = "-", .components = 3, .values = {0, no_value, 1}},
      {.name = "chain", .definition = "-", .missing = "no contacts"}};
  write_particles(folder / "bed.csv", s, fields);
  CHECK(read_text_file(folder / "bed.csv") ==
        "id,type,x [m],y [m],z [m],radius [m],pressure [Pa],direction_x,direction_y,direction_z\n"
        "1000,1,1,2,3,0.5,2.5,0,,1\n");
  write_particles(folder / "none.csv", empty_box(Vec3(1, 1, 1)), {{.name = "core", .definition = "-"}});
  CHECK(read_text_file(folder / "none.csv") == "id,type,x [m],y [m],z [m],radius [m],core\n");
}
