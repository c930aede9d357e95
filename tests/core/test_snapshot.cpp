#include <cmath>
#include <fstream>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/random.hpp"
#include "core/snapshot.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;

namespace {

Snapshot random_snapshot(std::size_t count) {
  Snapshot s;
  s.time = 1.25;
  s.step = 25000;
  s.domain = {Vec3(0, 0, 0), Vec3(1, 1, 2), {true, true, false}};
  s.gravity = Vec3(0, 0, -9.8);
  s.groups = {{"light", "foam", 1200}, {"heavy", "steel", 7800}};
  s.material_names = {"foam", "steel"};
  s.boundaries = {{"floor", "plane", Vec3(0, 0, 0.1), Vec3(0, 0, 1)}};
  s.scene_text = "title = \"\xc3\xa9\"\n";
  s.scene_hash = "0123456789abcdef";
  s.program = "packstone test";
  Field velocity{3, "m/s", {}}, energy{1, "J", {}};
  for (std::size_t i = 0; i < count; ++i) {
    Random r(1, RandomStream::filling_position, i);
    s.position.emplace_back(r.uniform(), r.uniform(), r.uniform(0, 2));
    s.radius.push_back(r.uniform(0.01, 0.03));
    s.id.push_back(static_cast<std::int64_t>(3 * i));
    s.type.push_back(static_cast<std::int32_t>(i % 2));
    s.material.push_back(static_cast<std::int32_t>(i % 2));
    for (int k = 0; k < 3; ++k) velocity.values.push_back(r.uniform(-1, 1));
    energy.values.push_back(r.uniform());
  }
  s.fields = {{"velocity", velocity}, {"energy", energy}};
  s.contacts = Contacts{{0, 3},
                        {3, -1},
                        {Vec3(1, 2, 3), Vec3(4, 5, 6)},
                        {Vec3(1, 0, 0), Vec3(0, 0, 1)},
                        {1e-6, 2e-6},
                        {Vec3(0, 0, 1), Vec3(0, 1, 0)},
                        {0, 1}};
  return s;
}

}  // namespace

TEST_CASE("a snapshot comes back as it was written, whatever the order of its rows") {
  const testing::TemporaryFolder folder;
  const Snapshot s = random_snapshot(10000);
  write_snapshot(folder / "a.vtkhdf", s);
  const Snapshot t = read_snapshot(folder / "a.vtkhdf");
  REQUIRE(t.size() == s.size());
  CHECK(t.time == s.time);
  CHECK(t.step == s.step);
  CHECK(t.scene_text == s.scene_text);
  CHECK(t.scene_hash == s.scene_hash);
  CHECK(t.program == s.program);
  CHECK(t.material_names == s.material_names);
  CHECK(t.groups[1].name == "heavy");
  CHECK(t.groups[1].density == 7800);
  CHECK(t.boundaries[0].point == s.boundaries[0].point);
  CHECK(t.domain.max == s.domain.max);
  CHECK(t.domain.periodic == s.domain.periodic);
  CHECK(t.gravity == s.gravity);
  const auto row = t.rows_by_id();
  bool same = true;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::size_t k = row.at(s.id[i]);
    same = same && t.position[k] == s.position[i] && t.radius[k] == s.radius[i] && t.type[k] == s.type[i] &&
           t.fields.at("energy").values[k] == s.fields.at("energy").values[i] &&
           t.fields.at("velocity").values[3 * k + 2] == s.fields.at("velocity").values[3 * i + 2];
  }
  CHECK(same);
  CHECK(t.fields.at("velocity").unit == "m/s");
  CHECK(t.contacts->second == s.contacts->second);
  CHECK(t.contacts->force[1] == s.contacts->force[1]);
  CHECK(t.contacts->sliding == s.contacts->sliding);
}

TEST_CASE("writing the same snapshot twice gives the same bytes") {
  const testing::TemporaryFolder folder;
  const Snapshot s = random_snapshot(500);
  write_snapshot(folder / "a.vtkhdf", s);
  write_snapshot(folder / "b.vtkhdf", s);
  CHECK(read_text_file(folder / "a.vtkhdf") == read_text_file(folder / "b.vtkhdf"));
}

TEST_CASE("neighbouring rows are near each other in space") {
  const testing::TemporaryFolder folder;
  write_snapshot(folder / "a.vtkhdf", random_snapshot(10000));
  const Snapshot t = read_snapshot(folder / "a.vtkhdf");
  double sum = 0;
  for (std::size_t i = 1; i < t.size(); ++i) sum += (t.position[i] - t.position[i - 1]).norm();
  // Two random points of this box are 0.9 apart on average.
  CHECK(sum / static_cast<double>(t.size()) < 0.12);
}

TEST_CASE("a region holds just the spheres that touch it") {
  const testing::TemporaryFolder folder;
  const Snapshot s = random_snapshot(20000);
  write_snapshot(folder / "a.vtkhdf", s);
  const Region region{Vec3(0.2, 0.3, 0.4), Vec3(0.35, 0.5, 0.7)};
  ReadOptions options;
  options.region = region;
  const Snapshot part = read_snapshot(folder / "a.vtkhdf", options);
  std::size_t expected = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const double outside = std::max({region.min[k] - s.position[i][k], s.position[i][k] - region.max[k], 0.0});
      squared += outside * outside;
    }
    expected += std::sqrt(squared) <= s.radius[i];
  }
  CHECK(expected > 50);
  CHECK(part.size() == expected);
  CHECK(part.fields.at("velocity").values.size() == 3 * expected);
}

TEST_CASE("an empty snapshot is a snapshot") {
  const testing::TemporaryFolder folder;
  Snapshot s = random_snapshot(0);
  s.contacts = Contacts{};
  write_snapshot(folder / "a.vtkhdf", s);
  const Snapshot t = read_snapshot(folder / "a.vtkhdf");
  CHECK(t.size() == 0);
  CHECK(t.contacts->size() == 0);
}

TEST_CASE("a damaged or foreign file is refused by name") {
  const testing::TemporaryFolder folder;
  write_snapshot(folder / "a.vtkhdf", random_snapshot(2000));
  const std::string bytes = read_text_file(folder / "a.vtkhdf");
  std::ofstream(folder / "cut.vtkhdf", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  std::ofstream(folder / "text.vtkhdf") << "not a snapshot";
  CHECK_THROWS_WITH(read_snapshot(folder / "cut.vtkhdf"), Contains("cut.vtkhdf"));
  CHECK_THROWS_WITH(read_snapshot(folder / "text.vtkhdf"), Contains("not a readable HDF5 file"));
  CHECK_THROWS_WITH(read_snapshot(folder / "absent.vtkhdf"), Contains("no such file"));
  Snapshot wrong = random_snapshot(10);
  wrong.type[3] = 9;
  write_snapshot(folder / "type.vtkhdf", wrong);
  CHECK_THROWS_WITH(read_snapshot(folder / "type.vtkhdf"), Contains("PointData/type"));
  wrong = random_snapshot(10);
  wrong.position[3][1] = std::nan("");
  write_snapshot(folder / "nan.vtkhdf", wrong);
  CHECK_THROWS_WITH(read_snapshot(folder / "nan.vtkhdf"), Contains("not a number"));
}

TEST_CASE("a snapshot that cannot be written leaves nothing behind") {
  CHECK_THROWS_AS(write_snapshot("/no/such/folder/a.vtkhdf", random_snapshot(3)), RunError);
}
