// Snapshots looked at in their files: the same numbers as those read, and damage found where it is looked at.
#include <cmath>

#include <catch2/catch.hpp>
#include <hdf5.h>

#include "core/error.hpp"
#include "core/open_snapshot.hpp"
#include "core/random.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;

namespace {

constexpr const char* points = "/VTKHDF/Points";
constexpr const char* radii = "/VTKHDF/PointData/radius";

Snapshot strewn_packing(int count) {
  Random random(5, RandomStream::filling_position, 0);
  Snapshot s;
  s.groups = {{"a", "glass", 1}, {"b", "glass", 1}};
  s.material_names = {"glass"};
  Field heat{3, "J", {}};
  for (int k = 0; k < count; ++k) {
    s.position.emplace_back(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    s.radius.push_back(random.uniform(0.001, 0.01));
    s.id.push_back(k);
    s.type.push_back(k % 2);
    s.material.push_back(0);
    heat.values.insert(heat.values.end(), {1.0 * k, 2.0, 3.0});
  }
  s.fields["heat"] = heat;
  return s;
}

template <class T>
bool same(std::span<const T> view, const std::vector<T>& read) {
  return std::equal(view.begin(), view.end(), read.begin(), read.end());
}

void check_same(const std::filesystem::path& file) {
  const Snapshot read = read_snapshot(file);
  const OpenSnapshot open(file);
  const ParticleView& view = open.view();
  CHECK(view.snapshot->size() == 0);
  CHECK(view.snapshot->groups.size() == 2);
  CHECK(same<Vec3>(view.position, read.position));
  CHECK(same<double>(view.radius, read.radius));
  CHECK(same<std::int32_t>(view.type, read.type));
  CHECK(same<std::int32_t>(view.material, read.material));
  CHECK(same<double>(view.fields.at("heat").values, read.fields.at("heat").values));
  CHECK(view.fields.at("heat").components == 3);
  CHECK(view.fields.at("heat").unit == "J");
  std::size_t rows = 0;
  for (const RowChunk& chunk : view.chunks) {
    CHECK(chunk.first == rows);
    rows = chunk.last;
    CHECK_NOTHROW(check_rows(view, chunk));
  }
  CHECK(rows == read.size());
}

/// Puts another dataset of the same numbers in the place of one, by a type of the file's and properties.
void store_anew(const std::filesystem::path& file, const char* name, std::vector<double> values, hid_t type,
                hid_t properties, std::vector<hsize_t> shape) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  REQUIRE(opened >= 0);
  REQUIRE(H5Ldelete(opened, name, H5P_DEFAULT) >= 0);
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t set = H5Dcreate2(opened, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  CHECK(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
  H5Dclose(set);
  H5Sclose(space);
  H5Fclose(opened);
}

/// Writes one number over a row of a dataset.
void damage(const std::filesystem::path& file, const char* name, hsize_t row, double value) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t set = H5Dopen2(opened, name, H5P_DEFAULT), space = H5Dget_space(set);
  const hsize_t start[2] = {row, 0}, count[2] = {1, 1};
  const hid_t memory = H5Screate_simple(1, count, nullptr);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
  CHECK(H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value) >= 0);
  H5Sclose(memory);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(opened);
}

}  // namespace

TEST_CASE("columns looked at in a file are those that are read") {
  const testing::TemporaryFolder folder;
  for (const int count : {0, 1, 63, 5000}) {
    INFO(count);
    write_snapshot(folder / "a.vtkhdf", strewn_packing(count));
    check_same(folder / "a.vtkhdf");
  }
}

TEST_CASE("columns that are compressed or of another type are read") {
  const testing::TemporaryFolder folder;
  const auto file = folder / "a.vtkhdf";
  write_snapshot(file, strewn_packing(5000));
  const Snapshot plain = read_snapshot(file);
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t piece[2] = {1000, 3};
  H5Pset_chunk(properties, 2, piece);
  H5Pset_deflate(properties, 1);
  store_anew(file, points, {plain.position[0].data(), plain.position[0].data() + 3 * plain.size()}, H5T_NATIVE_DOUBLE,
             properties, {plain.size(), 3});
  H5Pclose(properties);
  store_anew(file, radii, plain.radius, H5T_IEEE_F64BE, H5P_DEFAULT, {plain.size()});
  CHECK(read_snapshot(file).position == plain.position);
  check_same(file);
}

TEST_CASE("damaged rows are refused by name where they are looked at") {
  const testing::TemporaryFolder folder;
  const auto file = folder / "a.vtkhdf";
  const auto refused = [&](const char* name, double value) {
    write_snapshot(file, strewn_packing(9000));
    damage(file, name, 5000, value);
    const OpenSnapshot open(file);
    const ParticleView& view = open.view();
    REQUIRE(view.chunks.size() == 3);
    CHECK_NOTHROW(check_rows(view, view.chunks[0]));
    CHECK_NOTHROW(check_rows(view, view.chunks[2]));
    CHECK_THROWS_WITH(check_rows(view, view.chunks[1]), Contains("a.vtkhdf: rows 4096 to 8191"));
  };
  refused(points, std::nan(""));
  refused(points, HUGE_VAL);
  refused(points, 7);  // not in the chunk's box
  refused(radii, -1);
  refused(radii, std::nan(""));
  refused(radii, 0.5);  // reaches out of it
}

TEST_CASE("groups there are not are refused, and a file that is cut short") {
  const testing::TemporaryFolder folder;
  Snapshot wrong = strewn_packing(10);
  wrong.type[3] = 9;
  write_snapshot(folder / "type.vtkhdf", wrong);
  const OpenSnapshot open(folder / "type.vtkhdf");
  CHECK_THROWS_WITH(check_rows(open.view(), open.view().chunks[0]), Contains("PointData/type"));
  write_snapshot(folder / "a.vtkhdf", strewn_packing(5000));
  std::filesystem::resize_file(folder / "a.vtkhdf", std::filesystem::file_size(folder / "a.vtkhdf") / 2);
  CHECK_THROWS_WITH(OpenSnapshot(folder / "a.vtkhdf"), Contains("a.vtkhdf"));
  CHECK_THROWS_WITH(OpenSnapshot(folder / "absent.vtkhdf"), Contains("no such file"));
}

TEST_CASE("a snapshot in memory is looked at there") {
  const OpenSnapshot open(strewn_packing(100));
  CHECK(open.view().snapshot->size() == 100);
  CHECK(open.view().position.data() == open.view().snapshot->position.data());
  CHECK(chunks_of(open.view()).size() == 1);
}
