// Contacts with walls in dumps of LIGGGHTS (tests/data/liggghts_walls).
#include <algorithm>
#include <map>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/packing_series.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

const std::filesystem::path folder_of_bed = PACKSTONE_SOURCE_DIR "/tests/data/liggghts_walls";
constexpr double gravity = 9.8;  // of the deck [m/s2]

Snapshot bed() { return read_packing(folder_of_bed / "bed.dump"); }

/// A sphere of radius 1 that touches the floor z = 0 across the periodic side and the wall x = 3, and one in the air.
const std::string spheres =
    "ITEM: TIMESTEP\n3\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff pp ff\n0 3\n0 6\n0 9\n"
    "ITEM: ATOMS id x y z radius\n4 2.1 0.1 0.9 1\n7 1.5 3 5 1\n";

std::string dump_of(const std::vector<std::string>& rows, const std::string& columns) {
  std::string text = "ITEM: TIMESTEP\n3\nITEM: NUMBER OF ENTRIES\n" + std::to_string(rows.size()) +
                     "\nITEM: BOX BOUNDS ff pp ff\n0 3\n0 6\n0 9\nITEM: ENTRIES " + columns + "\n";
  for (const auto& row : rows) text += row + "\n";
  return text;
}

const std::string usual_columns =
    "c_w[1] c_w[2] c_w[3] c_w[4] c_w[5] c_w[6] c_w[7] c_w[8] c_w[9] c_w[10] c_w[11] c_w[12]";

Snapshot reading(const std::vector<std::string>& walls, const std::string& columns = usual_columns,
                 const PackingOptions& options = {}) {
  const TemporaryFolder folder;
  write_text_file(folder / "a.dump", spheres);
  write_text_file(folder / "a.dump.local", dump_of({}, "id1 id2 fx fy fz"));
  write_text_file(folder / "a.dump.wall", dump_of(walls, columns));
  return read_packing(folder / "a.dump", options);
}

}  // namespace

TEST_CASE("the walls of LIGGGHTS carry the weight of the bed at rest") {
  const Snapshot s = bed();
  double weight = 0;
  for (std::size_t i = 0; i < s.size(); ++i) weight += gravity * s.fields.at("mass").values[i];
  Vec3 by_walls = Vec3::Zero();
  std::size_t walls = 0;
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    if (s.contacts->second[k] >= 0) continue;
    ++walls;
    by_walls += s.contacts->force[k];
  }
  CHECK(walls == 35);  // as LIGGGHTS counts them
  CHECK(s.contacts->size() == walls + 61);
  CHECK((by_walls - Vec3(0, 0, weight)).norm() < 2e-6 * weight);  // what still moves the particles
}

TEST_CASE("forces of contacts and weight add up to each particle's force, as LIGGGHTS summed it") {
  const Snapshot s = bed();
  const auto rows = s.rows_by_id();
  std::vector<Vec3> force(s.size(), Vec3::Zero());
  for (std::size_t i = 0; i < s.size(); ++i) force[i].z() = -gravity * s.fields.at("mass").values[i];
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    force[rows.at(s.contacts->first[k])] += s.contacts->force[k];
    if (s.contacts->second[k] >= 0) force[rows.at(s.contacts->second[k])] -= s.contacts->force[k];
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    CHECK((force[i] - Vec3(&s.fields.at("force").values[3 * i])).norm() < 1e-10);
  }
}

TEST_CASE("contacts with LIGGGHTS' walls stand where the decks' meshes are") {
  const Snapshot s = bed();
  REQUIRE(s.boundaries.size() == 2);
  const Vec3 slope = Vec3(-0.2, 0, 1).normalized();  // of the floor z = 0.005 + 0.2 x
  for (std::size_t k = 0; k < s.contacts->size(); ++k) {
    if (s.contacts->second[k] >= 0) continue;
    const std::int64_t wall = -1 - s.contacts->second[k];
    REQUIRE((wall == 0 || wall == 1));
    const Vec3 &point = s.contacts->point[k], &normal = s.contacts->normal[k];
    if (wall == 0) {
      CHECK(std::abs(point.z() - 0.005 - 0.2 * point.x()) < 1e-8);  // the mesh has six digits
      CHECK((normal - slope).norm() < 1e-6);
    } else {
      const double aside = std::min({point.x(), 0.06 - point.x(), point.y(), 0.06 - point.y()});
      CHECK(std::abs(aside) < 1e-15);
      CHECK(std::abs(normal.z()) < 1e-12);
    }
    CHECK(s.contacts->overlap[k] > 0);
    CHECK(s.contacts->overlap[k] < 2e-4);
  }
}

TEST_CASE("a wall's contact has normal and overlap by its point, over the nearest image") {
  const Snapshot s = reading({"2.1 0.1 0 2.1 0.1 0.9 0 5 4 0 0 8", "3 0.1 0.9 2.1 0.1 0.9 2 0 4 -6 1 0"});
  const Contacts& c = s.contacts.value();
  REQUIRE(c.size() == 2);
  CHECK(c.first == std::vector<std::int64_t>{4, 4});
  CHECK(c.second == std::vector<std::int64_t>{-1, -3});
  CHECK(c.normal[0] == Vec3(0, 0, 1));
  CHECK(c.overlap[0] == Approx(0.1).epsilon(1e-14));
  CHECK(c.point[0] == Vec3(2.1, 0.1, 0));
  CHECK(c.force[1] == Vec3(-6, 1, 0));
  CHECK((c.normal[1] - Vec3(-1, 0, 0)).norm() < 1e-15);
  REQUIRE(s.boundaries.size() == 3);
  CHECK(s.boundaries[2].name == "wall 2");
  CHECK(std::count(s.notes.begin(), s.notes.end(), note_no_walls) == 1);
  const Contacts across = reading({"2.1 6 0 2.1 0.1 0.9 0 5 4 0 0 8"}).contacts.value();
  CHECK(across.overlap[0] == Approx(1 - std::sqrt(0.01 + 0.81)).epsilon(1e-12));
  CHECK(across.point[0] == Vec3(2.1, 0, 0));
  // A particle in the air has no contact, and one that touches without pressing has a contact without force.
  CHECK(reading({"1.5 3 4 1.5 3 5 0 0 7 0 0 0"}).contacts->size() == 0);
  CHECK(reading({"2.1 0.1 0 2.1 0.1 0.9 0 5 4 0 0 0"}).contacts->size() == 1);
  // Few digits leave no overlap: what presses touches all the same.
  const Contacts pressing = reading({"1.5 3 4 1.5 3 5 0 0 7 0 0 1"}).contacts.value();
  REQUIRE(pressing.size() == 1);
  CHECK(pressing.overlap[0] > 0);
  CHECK(pressing.overlap[0] < 1e-10);
}

TEST_CASE("a wall's columns mean what the file, the user or their number says") {
  const auto first = [](const Snapshot& s) { return s.contacts->second.at(0); };
  CHECK(first(reading({"2.1 0.1 0 2.1 0.1 0.9 0 0 8"}, "a b c d e f g h i")) == -1);  // by its centre
  CHECK(first(reading({"8 4 2.1 0.1 0 1 0 0"}, "fz id px py pz wall fx fy")) == -2);
  PackingOptions options;
  options.wall_columns = {"px", "py", "pz", "-", "-", "id", "wall", "fx", "fy", "fz"};
  CHECK(first(reading({"2.1 0.1 0 0 0 4 6 0 0 8"}, "a b c d e f g h i j", options)) == -7);
}

TEST_CASE("contacts with walls that do not fit are refused with their line") {
  const auto refused = [](const std::string& row, const std::string& why, const std::string& columns = usual_columns) {
    CHECK_THROWS_AS(reading({row}, columns), InputError);
    CHECK_THROWS_WITH(reading({row}, columns), Contains(why));
  };
  refused("2.1 0.1 0 2.1 0.1 0.9 0 5 9 0 0 8", "a.dump.wall:10: particle 9 is not among");
  refused("2.1 0.1 0 2.1 0.1 0.9 -1 5 4 0 0 8", "a.dump.wall:10: wall: -1 is no number of a wall");
  refused("2.1 0.1 0 2.1 0.1 0.9 1e300 5 4 0 0 8", "is no number of a wall");
  refused("2.1 0.1 0 2.1 0.1 0.9 0 5 4 0 nan 8", "a.dump.wall:10: fy: \"nan\" is not finite");
  refused("2.1 3 5 2.1 0.1 0.9 0 5 4 0 0 8", "a.dump.wall:10: the point of contact lies");
  refused("2.1 0.1 0.9 2.1 0.1 0.9 0 5 4 0 0 8", "a.dump.wall:10: the point of contact lies 0 m from");
  refused("2.1 0.1 0 1 1 1 0 0 8", "a.dump.wall:10: no particle's centre lies there", "a b c d e f g h i");
  refused("0 5 4 0 0 8", "a.dump.wall:9: the 6 columns do not say what they are; name them with --wall-columns",
          "a b c d e f");
  refused("4 0 0 8", "px, py, pz, id (or the centre x, y, z), fx, fy and fz are needed", "id fx fy fz");
  const TemporaryFolder folder;
  write_text_file(folder / "a.dump", spheres);
  PackingOptions options;
  options.wall_contacts = folder / "b.wall";
  CHECK_THROWS_WITH(read_packing(folder / "a.dump", options), Contains("name those with --contacts"));
}
