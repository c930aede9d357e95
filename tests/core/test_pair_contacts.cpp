// Contacts in dumps of style local.
#include <fstream>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/packing_series.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

/// Three spheres of radius 1 in a row along x, each 1.9 from the next, the last over the periodic side from the first.
const std::string spheres =
    "ITEM: TIMESTEP\n3\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp ff ff\n0 5.7\n-1 1\n-1 1\n"
    "ITEM: ATOMS id x y z radius\n1 0.5 0 0 1\n2 2.4 0 0 1\n3 4.3 0 0 1\n";

std::string contacts_file(const std::string& columns, const std::vector<std::string>& rows) {
  std::string text = "ITEM: TIMESTEP\n3\nITEM: NUMBER OF ENTRIES\n" + std::to_string(rows.size()) +
                     "\nITEM: BOX BOUNDS pp ff ff\n0 5.7\n-1 1\n-1 1\nITEM: ENTRIES " + columns + "\n";
  for (const auto& row : rows) text += row + "\n";
  return text;
}

Contacts contacts_in(const std::string& text, const std::vector<std::string>& columns = {}) {
  const TemporaryFolder folder;
  write_text_file(folder / "a.dump", spheres);
  write_text_file(folder / "a.dump.local", text);
  PackingOptions options;
  options.contact_columns = columns;
  return read_packing(folder / "a.dump", options).contacts.value();
}

}  // namespace

TEST_CASE("contacts go by ids, with normal, overlap and point over the nearest image") {
  const Contacts c = contacts_in(contacts_file("c_1[1] c_1[2] c_2[1] c_2[2] c_2[3]", {"1 2 -4 1 0", "1 3 7 0 0"}));
  REQUIRE(c.size() == 2);
  CHECK(c.first == std::vector<std::int64_t>{1, 1});
  CHECK(c.second == std::vector<std::int64_t>{2, 3});
  CHECK(c.force[0] == Vec3(-4, 1, 0));
  CHECK(c.normal[0] == Vec3(-1, 0, 0));
  CHECK(c.overlap[0] == Approx(0.1).epsilon(1e-12));
  CHECK((c.point[0] - Vec3(1.45, 0, 0)).norm() < 1e-12);
  CHECK(c.normal[1] == Vec3(1, 0, 0));  // the neighbour stands across the periodic side
  CHECK(c.overlap[1] == Approx(0.1).epsilon(1e-12));
  CHECK((c.point[1] - Vec3(5.25, 0, 0)).norm() < 1e-12);
  CHECK(c.sliding.empty());
}

TEST_CASE("columns mean what the file, the user or their number says") {
  const std::vector<std::string> liggghts = {"0.5 0 0 2.4 0 0 1 2 0 -4 1 0"};
  CHECK(contacts_in(contacts_file("a b c d e f g h i j k l", liggghts)).force[0] == Vec3(-4, 1, 0));
  CHECK(contacts_in(contacts_file("a b c d e f", {"2 3 0 -5 0 1"})).force[0] == Vec3(-5, 0, 1));
  CHECK(contacts_in(contacts_file("fx fy fz id2 id1 extra", {"-5 0 1 3 2 9"})).first[0] == 2);
  const Contacts parts = contacts_in(contacts_file("a b c d e f g h i", {"1 2 77 -4 0 0 0 1 2"}),
                                     {"id1", "id2", "-", "fx", "fy", "fz", "ftx", "fty", "ftz"});
  CHECK(parts.force[0] == Vec3(-4, 1, 2));
}

TEST_CASE("contacts go by centres printed with few digits, a wall's are left out") {
  const Contacts c = contacts_in(contacts_file(
      "a b c d e f g h i", {"2.4003 0 0 4.2996 0 0 -2 0 0", "0.5 0 0 0.5 0 -1 3 3 3", "-1.4 0 0 0.5 0 0 -1 0 0"}));
  REQUIRE(c.size() == 2);
  CHECK(c.first == std::vector<std::int64_t>{3, 2});  // along the rows: the pair with the lowest first
  CHECK(c.second == std::vector<std::int64_t>{1, 3});
  CHECK(c.force[0] == Vec3(-1, 0, 0));
}

TEST_CASE("a pair that comes twice counts once, one that does not touch not at all") {
  const Contacts c = contacts_in(contacts_file("id1 id2 fx fy fz", {"1 2 -4 0 0", "2 1 4 0 0"}));
  CHECK(c.size() == 1);
  CHECK(contacts_in(contacts_file("id1 id2 fx fy fz", {})).size() == 0);
}

TEST_CASE("a pair that presses touches, also where few digits leave no overlap") {
  const auto overlap = [](const std::string& x, const std::string& force) {
    const TemporaryFolder folder;
    write_text_file(folder / "a.dump",
                    "ITEM: TIMESTEP\n3\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 "
                    "9\nITEM: ATOMS id x y z radius\n1 1 1 1 1\n2 " +
                        x + " 1 1 1\n");
    write_text_file(folder / "a.dump.local", contacts_file("id1 id2 fx fy fz", {"1 2 " + force + " 0 0"}));
    const Contacts c = read_packing(folder / "a.dump").contacts.value();
    return c.size() == 1 ? c.overlap[0] : -1;
  };
  CHECK(overlap("3", "-1") == Approx(2e-12).margin(1e-20));
  CHECK(overlap("3.0001", "-1") == Approx(2e-12).margin(1e-20));
  CHECK(overlap("3.1", "-1") == Approx(-0.1));
  CHECK(overlap("3.0001", "1") == Approx(-1e-4));  // attraction across a gap
  CHECK(overlap("3.0001", "0") == -1);
  CHECK(overlap("2.9", "0") == Approx(0.1));
}

TEST_CASE("contacts that do not fit are refused with their line") {
  const auto refused = [](const std::string& columns, const std::vector<std::string>& rows, const std::string& why,
                          const std::vector<std::string>& names = {}) {
    CHECK_THROWS_AS(contacts_in(contacts_file(columns, rows), names), InputError);
    CHECK_THROWS_WITH(contacts_in(contacts_file(columns, rows), names), Contains(why));
  };
  refused("id1 id2 fx fy fz", {"1 2 0 0 1", "1 7 0 0 1"}, "a.dump.local:11: particle 7 is not among");
  refused("id1 id2 fx fy fz", {"1 1 0 0 1"}, "a.dump.local:10: particle 1 touches itself");
  refused("id1 id2 fx fy fz", {"1 1e300 0 0 1"}, "is not among");
  refused("id1 id2 fx fy fz", {"1 2 0 nan 1"}, "a.dump.local:10: fy: \"nan\" is not finite");
  refused("a b c", {"1 2 3"}, "a.dump.local:9: the 3 columns do not say what they are");
  refused("a b c d e", {"1 2 0 0 1"}, "the file has 5 columns, --contact-columns names 2", {"id1", "id2"});
  refused("a b c d e", {"1 2 0 0 1"}, "\"id3\" is no column of contacts", {"id1", "id3", "fx", "fy", "fz"});
  refused("a b c d e", {"1 2 0 0 1"}, "fx, fy and fz are needed", {"id1", "id2", "fx", "fy", "-"});
  const std::string other_step = contacts_file("id1 id2 fx fy fz", {});
  CHECK_THROWS_WITH(contacts_in("ITEM: TIMESTEP\n4" + other_step.substr(16)), Contains("has no contacts of step 3"));
  CHECK_THROWS_WITH(contacts_in("hello"), Contains("is no dump of contacts"));
  CHECK_THROWS_WITH(contacts_in(spheres), Contains("holds particles, not contacts"));
}
