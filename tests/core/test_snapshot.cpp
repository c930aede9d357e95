#include <cmath>
#include <cstring>
#include <fstream>

#include <catch2/catch.hpp>

#include "core/checksums.hpp"
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

/// Two walls with a surface around one that has none; numbers of points and triangles differ.
std::vector<BoundaryRecord> walls_of_all_sorts() {
  BoundaryRecord drum{.name = "drum", .kind = "cylinder"};
  drum.point = Vec3(0.5, 0.5, 0.05);
  drum.normal = Vec3::UnitZ();
  drum.axis = Vec3::UnitZ();
  drum.cross_section = 0.785;
  drum.points = {Vec3(0, 0, 0.1), Vec3(1, 0, 0.2), Vec3(0, 1, 0.3), Vec3(-1, 0, 0.4)};
  drum.triangles = {{0, 1, 2}, {0, 2, 3}};
  BoundaryRecord floor{.name = "floor", .kind = "plane", .point = Vec3(0, 0, 0.1), .normal = Vec3::UnitZ()};
  BoundaryRecord blade{.name = "blade", .kind = "polygons", .one_sided = false};
  blade.points = {Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 0)};
  blade.triangles = {{2, 1, 0}};
  return {drum, floor, blade};
}

/// The file with these numbers put in the place of those, which must be there once.
std::string patched(const std::string& bytes, const std::vector<std::int64_t>& from,
                    const std::vector<std::int64_t>& to) {
  const auto raw = [](const std::vector<std::int64_t>& numbers) {
    std::string text(numbers.size() * sizeof(std::int64_t), '\0');
    std::memcpy(text.data(), numbers.data(), text.size());
    return text;
  };
  std::string result = bytes;
  const std::size_t at = bytes.find(raw(from));
  REQUIRE(at != std::string::npos);
  REQUIRE(bytes.find(raw(from), at + 1) == std::string::npos);
  return result.replace(at, raw(to).size(), raw(to));
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

TEST_CASE("boundaries come back with their surfaces, each with its own") {
  const testing::TemporaryFolder folder;
  Snapshot s = random_snapshot(10);
  s.boundaries = walls_of_all_sorts();
  write_snapshot(folder / "a.vtkhdf", s);
  const Snapshot t = read_snapshot(folder / "a.vtkhdf");
  REQUIRE(t.boundaries.size() == s.boundaries.size());
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    const BoundaryRecord& was = s.boundaries[k];
    const BoundaryRecord& is = t.boundaries[k];
    CHECK(is.name == was.name);
    CHECK(is.kind == was.kind);
    CHECK(is.point == was.point);
    CHECK(is.normal == was.normal);
    CHECK(is.axis == was.axis);
    CHECK(is.cross_section == was.cross_section);
    CHECK(is.one_sided == was.one_sided);
    CHECK(is.points == was.points);
    CHECK(is.triangles == was.triangles);
  }
  s.boundaries.clear();
  s.contacts.reset();
  write_snapshot(folder / "none.vtkhdf", s);
  CHECK(read_snapshot(folder / "none.vtkhdf").boundaries.empty());
}

TEST_CASE("a file from before there were surfaces is read") {
  const Snapshot s = read_snapshot(PACKSTONE_SOURCE_DIR "/tests/data/snapshot_planes_only.vtkhdf");
  CHECK(s.program == "packstone 0.1.0 (git 27d944f)");
  CHECK(s.size() == 12);
  REQUIRE(s.boundaries.size() == 1);
  const BoundaryRecord& floor = s.boundaries[0];
  CHECK(floor.kind == "plane");
  CHECK(floor.point == Vec3(0, 0, 0.01));
  CHECK(floor.normal == Vec3::UnitZ());
  CHECK(floor.axis == Vec3::Zero());
  CHECK(floor.cross_section == 0);
  CHECK(floor.one_sided);
  CHECK(floor.points.empty());
  CHECK(floor.triangles.empty());
}

TEST_CASE("surfaces that refer to what is not there are refused") {
  const testing::TemporaryFolder folder;
  Snapshot s = random_snapshot(10);
  const auto refused = [&](const std::string& why) {
    CHECK_THROWS_AS(read_snapshot(folder / "bad.vtkhdf"), InputError);
    CHECK_THROWS_WITH(read_snapshot(folder / "bad.vtkhdf"), Contains("bad.vtkhdf") && Contains(why));
  };
  // The last boundary has 3 points of its own, though the file holds more.
  for (const std::int32_t corner : {-1, 3}) {
    s.boundaries = walls_of_all_sorts();
    s.boundaries[2].triangles[0][1] = corner;
    write_snapshot(folder / "bad.vtkhdf", s);
    refused("surface_triangles");
  }
  s.boundaries = walls_of_all_sorts();
  s.boundaries[0].points[1].y() = HUGE_VAL;
  write_snapshot(folder / "bad.vtkhdf", s);
  refused("surface_points");

  s.boundaries = walls_of_all_sorts();
  write_snapshot(folder / "good.vtkhdf", s);
  std::string bytes = read_text_file(folder / "good.vtkhdf");
  bytes.resize(bytes.size() - Checksums::behind(bytes)->text().size());  // which would tell before
  const auto write_patched = [&](const std::vector<std::int64_t>& from, const std::vector<std::int64_t>& to) {
    std::ofstream(folder / "bad.vtkhdf", std::ios::binary) << patched(bytes, from, to);
  };
  const std::vector<std::int64_t> first_point = {0, 4, 4, 7}, first_triangle = {0, 2, 2, 3};
  for (const auto& wrong : {std::vector<std::int64_t>{0, 5, 4, 7}, {1, 4, 4, 7}, {0, 4, 4, 8}, {0, -4, 4, 7}}) {
    write_patched(first_point, wrong);
    refused("surface_first_point");
  }
  for (const auto& wrong : {std::vector<std::int64_t>{0, 3, 2, 3}, {0, 2, 2, 1'000'000'000}, {-1, 2, 2, 3}}) {
    write_patched(first_triangle, wrong);
    refused("surface_first_triangle");
  }
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
