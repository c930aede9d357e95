// Snapshots cut short or changed by a bit anywhere: never a crash, and with checksums never another packing.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "core/checksums.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/packing_series.hpp"
#include "core/open_snapshot.hpp"
#include "core/snapshot.hpp"
#include "random_packing.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::random_packing;

namespace {

constexpr std::size_t particles = 300;

struct DamagedFile {
  testing::TemporaryFolder folder;
  std::filesystem::path path = folder / "a b\xc3\xa4.vtkhdf";
  std::string whole;
  std::size_t structure_and_columns;  ///< bytes of the file without its checksums

  DamagedFile() {
    Snapshot s = random_packing(particles);
    s.scene_text = "title = \"text of some length\"";
    write_snapshot(path, s);
    whole = read_text_file(path);
    structure_and_columns = whole.size() - Checksums::behind(whole)->text().size();
  }
  void write(const std::string& bytes) const { std::ofstream(path, std::ios::binary) << bytes; }
};

std::string with_bit_flipped(std::string bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
  return bytes;
}

/// Reads in every way that there is; false where one of them refuses the file.
bool is_read(const std::filesystem::path& path) {
  try {
    PackingSeries({path}).snapshot(0);
    const OpenSnapshot open(path);
    for (const RowChunk& chunk : open.view().chunks) check_rows(open.view(), chunk);
    return true;
  } catch (const InputError& error) {
    CHECK_THAT(error.what(), Contains(path.filename().string()));
    CHECK_THAT(error.what(), !Contains("\n"));
    return false;
  }
}

}  // namespace

TEST_CASE("one bit of a snapshot changed anywhere is told, or changes nothing of the packing") {
  const DamagedFile file;
  REQUIRE(is_read(file.path));
  std::size_t told = 0, tried = 0;
  for (std::size_t bit = 0; bit < 8 * file.structure_and_columns; bit += 331, ++tried) {
    INFO("bit " << bit);
    file.write(with_bit_flipped(file.whole, bit));
    try {
      const Snapshot s = read_snapshot(file.path);
      write_snapshot(file.folder / "again.vtkhdf", s);
      CHECK((read_text_file(file.folder / "again.vtkhdf") == file.whole));
    } catch (const InputError&) {
      ++told;
    }
  }
  CHECK(told > 0.85 * static_cast<double>(tried));  // all but those in the cells, which follow from the number of points
}

TEST_CASE("a damaged checksum does not make a good snapshot unreadable") {
  const DamagedFile file;
  for (const std::size_t bit : {8 * file.structure_and_columns + 5, 8 * file.whole.size() - 1}) {
    file.write(with_bit_flipped(file.whole, bit));
    CHECK(is_read(file.path));
  }
}

TEST_CASE("a snapshot cut short is refused, but for its checksums alone") {
  const DamagedFile file;
  for (std::size_t length = 0; length < file.structure_and_columns; length += 997) {
    INFO(length << " bytes");
    file.write(file.whole.substr(0, length));
    CHECK_FALSE(is_read(file.path));
  }
  file.write(file.whole.substr(0, file.structure_and_columns));
  CHECK(is_read(file.path));
}

TEST_CASE("without checksums no bit of a snapshot makes a reader crash") {
  const DamagedFile file;
  const std::string bare = file.whole.substr(0, file.structure_and_columns);
  std::size_t refused = 0;
  for (std::size_t bit = 0; bit < 8 * bare.size(); bit += 2111) {
    INFO("bit " << bit);
    file.write(with_bit_flipped(bare, bit));
    refused += is_read(file.path) ? 0 : 1;
  }
  CHECK(refused > 10);
}

TEST_CASE("numbers that no packing has are refused by name") {
  const testing::TemporaryFolder folder;
  const auto refused = [&](const char* words, const auto& spoil) {
    Snapshot s = random_packing(particles);
    s.boundaries = {{"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}};
    s.contacts = Contacts{{5}, {8}, {Vec3::UnitX()}, {Vec3::UnitX()}, {1e-3}, {Vec3::Zero()}, {1}};
    spoil(s);
    write_snapshot(folder / "bad.vtkhdf", s);
    CHECK_THROWS_WITH(read_snapshot(folder / "bad.vtkhdf"), Contains("bad.vtkhdf: ") && Contains(words));
  };
  const double nan = std::nan("");
  refused("radius is negative", [](Snapshot& s) { s.radius[7] = -1; });
  refused("occurs twice", [](Snapshot& s) { s.id[7] = s.id[8]; });
  refused("id is negative", [](Snapshot& s) { s.id[7] = -1; });
  refused("the time nan", [&](Snapshot& s) { s.time = nan; });
  refused("is not a box", [](Snapshot& s) { s.domain.max.x() = s.domain.min.x() - 1; });
  refused("gravity", [&](Snapshot& s) { s.gravity.z() = nan; });
  refused("group_density", [](Snapshot& s) { s.groups[0].density = -2; });
  refused("where floor stands", [&](Snapshot& s) { s.boundaries[0].normal.x() = nan; });
  refused("there is no particle", [](Snapshot& s) { s.contacts->first[0] = 1 << 30; });
  refused("5 and 5 are no particle", [](Snapshot& s) { s.contacts->second[0] = 5; });
  refused("5 and -2 are no particle", [](Snapshot& s) { s.contacts->second[0] = -2; });
  refused("is not a number", [&](Snapshot& s) { s.contacts->force[0].y() = nan; });
}

TEST_CASE("a file of a format to come is refused with both versions") {
  const DamagedFile file;
  std::string bare = file.whole.substr(0, file.structure_and_columns);
  // The format's version stands behind the header of its dataset, the last of the whole numbers 1 of 64 bits that a
  // change makes a newer format.
  const std::string one("\x01\0\0\0\0\0\0\0", 8);
  bool told = false;
  for (std::size_t at = bare.find(one); at != std::string::npos && !told; at = bare.find(one, at + 1)) {
    std::string newer = bare;
    newer[at] = 9;
    file.write(newer);
    try {
      read_snapshot(file.path);
    } catch (const InputError& error) {
      told = std::string(error.what()).find("newer packstone (format 9); this one reads up to 1") != std::string::npos;
    }
  }
  CHECK(told);
}
