// The list of measures, and snapshots at the edge of what can be measured.
#include <cmath>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <omp.h>

#include "analysis/writers.hpp"
#include "core/error.hpp"
#include "tests/analysis/fixtures.hpp"

using namespace packstone;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;

namespace {

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& measure : analysis::all_measures()) names.push_back(measure.name);
  return names;
}

void check_clear(const Snapshot& s) {
  const auto results = analysis::analyze(s, all_names());
  REQUIRE(results.size() == analysis::all_measures().size());
  for (const auto& result : results) {
    std::set<std::string> keys;
    for (const auto& q : result.quantities) {
      INFO(result.name << "." << q.key);
      CHECK(keys.insert(q.key).second);
      CHECK_FALSE(q.definition.empty());
      CHECK_FALSE(q.label.empty());
      if (q.value) {
        CHECK(std::isfinite(*q.value));
      } else {
        CHECK_FALSE(q.note.empty());
        CHECK_FALSE(q.uncertainty);
      }
      if (q.uncertainty) CHECK((std::isfinite(*q.uncertainty) && *q.uncertainty >= 0));
    }
    for (const auto& table : result.tables) {
      CHECK(keys.insert(table.key).second);
      for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
    }
  }
}

std::set<std::string> keys_of(const Snapshot& s) {
  std::set<std::string> keys;
  for (const auto& result : analysis::analyze(s, all_names())) {
    for (const auto& q : result.quantities) keys.insert(result.name + "." + q.key);
  }
  return keys;
}

}  // namespace

TEST_CASE("every snapshot gets clear answers") {
  SECTION("empty") { check_clear(empty_box(Vec3(1, 1, 1))); }
  SECTION("one particle") {
    Snapshot s = empty_box(Vec3(4, 4, 4));
    add_particle(s, Vec3(2, 2, 1), 1);
    check_clear(s);
  }
  SECTION("radii of 0") {
    Snapshot s = cubic_bed(3, 3, 3);
    label(s, [](int x, int, int) { return x % 2; });
    std::fill(s.radius.begin(), s.radius.end(), 0.0);
    check_clear(s);
  }
  SECTION("some radii of 0, moving") {
    Snapshot s = cubic_bed(3, 3, 3);
    label(s, [](int x, int, int) { return x % 2; });
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s.position[i].z() > 2) s.radius[i] = 0;
    }
    s.fields["velocity"] = {3, "m/s", std::vector<double>(3 * s.size(), 0.1)};
    check_clear(s);
    CHECK(measured(s, "time").quantity("granular_temperature")->value);
  }
  SECTION("radii of 0 with stored contacts") {
    Snapshot s = cubic_bed(3, 3, 3);
    label(s, [](int x, int, int) { return x % 2; });
    std::fill(s.radius.begin(), s.radius.end(), 0.0);
    s.contacts = Contacts{{s.id[0]}, {s.id[1]}, {Vec3(0, 0, 1)}, {Vec3(0, 0, 1)}, {1e-6}, {Vec3::Zero()}, {0}};
    check_clear(s);
  }
  SECTION("all below the floor") {
    Snapshot s = cubic_bed(3, 3, 3);
    label(s, [](int x, int, int) { return x % 2; });
    for (auto& p : s.position) p.z() -= 100;
    check_clear(s);
  }
  SECTION("all at one place") {
    Snapshot s = empty_box(Vec3(4, 4, 4));
    for (int i = 0; i < 10; ++i) add_particle(s, Vec3(2, 2, 2), 1, i % 2);
    check_clear(s);
  }
  SECTION("a dilute gas of two sizes, nothing touching") {
    Snapshot s = empty_box(Vec3(100, 100, 100));
    for (int i = 0; i < 20; ++i) add_particle(s, Vec3(5 + 4 * i, 5 + 4 * i, 5 + 4 * i), i % 2 ? 1.0 : 0.1, i % 2);
    check_clear(s);
  }
  SECTION("wholly periodic, two types") {
    Snapshot s = lattice(face_centred, 3, 3, 3, 1.0, 0.36);
    label_at_random(s, 2);
    check_clear(s);
  }
}

TEST_CASE("the keys are the same for every snapshot") {
  Snapshot s = cubic_bed(4, 4, 4);
  const auto keys = keys_of(s);
  CHECK(keys_of(empty_box(Vec3(1, 1, 1))) == keys);
  label_at_random(s, 1);
  CHECK(keys_of(s) == keys);
  for (const char* key : {"packing.bulk_fraction", "structure.coordination_mean", "segregation.lacey"}) {
    CHECK(keys.count(key) == 1);
  }
}

TEST_CASE("results do not depend on the number of threads") {
  Snapshot s = cubic_bed(18, 18, 18);  // several blocks of every sum
  label_at_random(s, 1);
  s.fields["velocity"] = {3, "m/s", std::vector<double>(3 * s.size())};
  Random random(1, RandomStream::filling_position, 0);
  for (double& v : s.fields["velocity"].values) v = random.uniform(-1, 1);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = analysis::to_json(analysis::analyze(s, all_names()));
  omp_set_num_threads(3);
  const auto three = analysis::to_json(analysis::analyze(s, all_names()));
  omp_set_num_threads(before);
  CHECK(one == three);
}

TEST_CASE("measures are selected by name") {
  const Snapshot s = cubic_bed(3, 3, 3);
  const auto results = analysis::analyze(s, {"structure", "packing"});
  REQUIRE(results.size() == 2);
  CHECK(results[0].name == "packing");
  CHECK_THROWS_WITH(analysis::analyze(s, {"packng"}), Contains("'packng'") && Contains("did you mean 'packing'"));
  CHECK_THROWS_AS(analysis::analyze(s, {"weather"}), InputError);
}

TEST_CASE("a snapshot that contradicts itself is refused") {
  Snapshot s = cubic_bed(3, 3, 3);
  SECTION("radii missing") { s.radius.pop_back(); }
  SECTION("position not a number") { s.position[4].y() = std::nan(""); }
  SECTION("negative radius") { s.radius[4] = -1; }
  SECTION("unknown type") { s.type[4] = 9; }
  SECTION("short field") { s.fields["velocity"] = {3, "m/s", {1, 2, 3}}; }
  SECTION("contacts of unequal columns") {
    s.contacts = Contacts{};
    s.contacts->first = {1, 2};
  }
  CHECK_THROWS_AS(analysis::analyze(s), InputError);
}

TEST_CASE("a layer must have a thickness") {
  CHECK_THROWS_AS(measured(cubic_bed(3, 3, 3), "packing", {.profile_layer = -1}), InputError);
}
