// What is written comes back, and what is not right is refused with its line.
#include <algorithm>
#include <fstream>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/packing_output.hpp"
#include "core/formats/packing_series.hpp"
#include "tests/core/random_packing.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using testing::random_packing;
using testing::TemporaryFolder;

namespace {

/// What reading such a file says, without the folder's name.
std::string refusal(const std::string& text, const std::string& name) {
  const TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << text;
  try {
    read_packing(folder / name);
  } catch (const InputError& error) {
    const std::string what = error.what(), before = folder.path().string() + "/";
    return what.starts_with(before) ? what.substr(before.size()) : what;
  }
  return "no refusal";
}

Snapshot by_id(const Snapshot& s) { return with_rows(s, id_order(s)); }

/// The particles by id.
Snapshot reading(const std::string& text, const std::string& name) {
  const TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << text;
  return by_id(read_packing(folder / name));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

const std::string dump =
    "ITEM: TIMESTEP\n20\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp ff mm\n0 2\n-1 1\n0 4\n"
    "ITEM: ATOMS id type x y z radius mass vx vy vz\n"
    "9 2 0.5 0.25 1 0.1 0.03 1 2 3 \n"
    "4 1 2.25 0 2 0.2 0.07 0 0 -1\n";

const std::string extended_xyz =
    "2\nLattice=\"2 0 0 0 3 0 0 0 4\" Origin=\"-1 0 0\" pbc=\"T F F\" Time=0.5 "
    "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3\n"
    "sand 0.5 1 2 0.1 1 2 3\n"
    "glass -0.5 1 2 0.2 4 5 6\n";

}  // namespace

TEST_CASE("a packing comes back from every format to the last bit") {
  const TemporaryFolder folder;
  const Snapshot s = random_packing(1000);
  const std::string extension = GENERATE(".vtkhdf", ".dump", ".data", ".csv", ".xyz");
  CAPTURE(extension);
  write_packing(folder / ("a" + extension), s);
  const Snapshot t = read_packing(folder / ("a" + extension));
  REQUIRE(t.size() == s.size());
  const auto rows = t.rows_by_id();
  bool same = true;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::size_t k = rows.at(s.id[i]);
    same = same && t.position[k] == s.position[i] && t.radius[k] == s.radius[i] && t.type[k] == s.type[i];
    for (const char* name : {"velocity", "angular_velocity"}) {
      for (std::size_t c = 0; c < 3; ++c) {
        same = same && t.fields.at(name).values[3 * k + c] == s.fields.at(name).values[3 * i + c];
      }
    }
  }
  CHECK(same);
  for (std::size_t g = 0; g < 2; ++g) CHECK(t.groups[g].density == Approx(s.groups[g].density).epsilon(1e-12));
  const bool has_box = extension != ".csv", has_time = has_box && extension != ".data";
  const bool has_forces = extension != ".data";
  CHECK(t.fields.count("force") == (has_forces ? 1 : 0));
  if (has_forces) CHECK(t.fields.at("force").values[3 * rows.at(5)] == s.fields.at("force").values[0]);
  if (has_box) CHECK(t.domain.min == s.domain.min);
  if (has_box) CHECK((t.domain.max - s.domain.max).norm() < 1e-15);
  if (has_time) CHECK(t.domain.periodic == s.domain.periodic);
  if (has_time) CHECK(t.time == s.time);
  if (has_time) CHECK(t.step == s.step);
}

TEST_CASE("several instants go into one dump and one XYZ file, and come back in order") {
  const TemporaryFolder folder;
  const auto file = folder / GENERATE("a.lammpstrj", "a.extxyz");
  PackingWriter writer(file);
  for (int k = 0; k < 3; ++k) {
    Snapshot s = random_packing(10 + static_cast<std::size_t>(k));
    s.time = 0.5 * k;
    writer.write(s);
    CHECK_FALSE(std::filesystem::exists(file));  // nobody takes some of the instants for all
  }
  writer.finish();
  const PackingSeries series({file});
  REQUIRE(series.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(series.time(k) == 0.5 * static_cast<double>(k));
    CHECK(series.snapshot(k).size() == 10 + k);
  }
  PackingWriter table(folder / "a.csv");
  table.write(random_packing(2));
  CHECK_THROWS_WITH(table.write(random_packing(2)), Contains("holds one instant"));
  CHECK_THROWS_WITH(write_packing(folder / "a.png", random_packing(2)), Contains("\".png\" is no format"));
  CHECK_THROWS_AS(write_packing("/no/such/folder/a.csv", random_packing(2)), RunError);
}

TEST_CASE("particles without size yet, as growth begins with, come back") {
  const TemporaryFolder folder;
  Snapshot s = random_packing(10);
  std::fill(s.radius.begin(), s.radius.end(), 0.0);
  const std::string extension = GENERATE(".vtkhdf", ".dump", ".csv", ".xyz");
  CAPTURE(extension);
  write_packing(folder / ("a" + extension), s);
  const Snapshot t = read_packing(folder / ("a" + extension));
  CHECK(t.radius == s.radius);
  CHECK(by_id(t).position == s.position);
}

TEST_CASE("a dump's particles come with what its columns say") {
  const Snapshot s = reading(dump, "a.dump");
  CHECK(s.id == std::vector<std::int64_t>{4, 9});
  CHECK(s.position[0] == Vec3(0.25, 0, 2));  // a periodic image inside the box
  CHECK(s.position[1] == Vec3(0.5, 0.25, 1));
  CHECK(s.radius == std::vector<double>{0.2, 0.1});
  CHECK(s.type == std::vector<std::int32_t>{0, 1});
  CHECK(s.groups[1].name == "type 2");
  CHECK(s.groups[1].density == Approx(0.03 / (4.0 / 3.0 * M_PI * 1e-3)).epsilon(1e-14));
  CHECK(s.fields.at("velocity").values == std::vector<double>{0, 0, -1, 1, 2, 3});
  CHECK(s.domain.min == Vec3(0, -1, 0));
  CHECK(s.domain.periodic == std::array<bool, 3>{true, false, false});
  CHECK(s.step == 20);
  CHECK(s.time == 0);
  CHECK_FALSE(s.contacts);
  CHECK_THAT(s.notes.at(0), Contains("steps, not times"));
  PackingOptions options;
  options.time_step = 1e-3;
  const TemporaryFolder folder;
  write_text_file(folder / "a.dump", dump);
  CHECK(read_packing(folder / "a.dump", options).time == Approx(0.02));
}

TEST_CASE("a dump's diameters, scaled and unwrapped places mean radii and places in the box") {
  const std::string rows =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n1 3\n0 1\n0 4\n"
      "ITEM: ATOMS id xs yu zsu diameter ix element omegaz c_stress[1]\n"
      "1 0.25 -0.75 0.5 0.5 -3 glass 7 8\n";
  const Snapshot s = reading(rows, "a.dump");
  CHECK(s.position[0] == Vec3(1.5, 0.25, 2));
  CHECK(s.radius[0] == 0.25);
  CHECK(s.groups[0].name == "glass");
  CHECK(s.groups[0].density == 0);
  CHECK_FALSE(s.has_masses());
  CHECK(s.fields.at("angular_velocity").values == std::vector<double>{0, 0, 7});
  CHECK(s.fields.at("c_stress[1]").values == std::vector<double>{8});
  CHECK(s.fields.count("ix") == 0);
}

TEST_CASE("a dump that is not right is refused with its line") {
  const auto after = [](const std::string& from, const std::string& to) {
    return refusal(replaced(dump, from, to), "a.dump");
  };
  CHECK_THAT(after("0.5 0.25 1", "0.5 0,25 1"),
             StartsWith("a.dump:10: y: \"0,25\" is not a number") && Contains("comma"));
  CHECK_THAT(after("0.5 0.25", "0.5 nan"), StartsWith("a.dump:10: y: \"nan\" is not finite"));
  CHECK_THAT(after("2.25 0 2", "2.25 2"), StartsWith("a.dump:11: the row has 9 fields, the header 10"));
  CHECK_THAT(after("0 0 -1", "0 0 -1 7 7"), StartsWith("a.dump:11: the row has 12 fields, the header 10"));
  CHECK_THAT(after("4 1 2.25", "9 1 2.25"), Contains("id: 9 occurs twice"));
  CHECK_THAT(after("4 1 2.25", "4 0 2.25"), StartsWith("a.dump:11: type: 0 is out of range; types go from 1"));
  CHECK_THAT(after("4 1 2.25", "4 1.5 2.25"), StartsWith("a.dump:11: type: 1.5 is not a whole number"));
  CHECK_THAT(after("4 1 2.25", "-4 1 2.25"), StartsWith("a.dump:11: id: -4 is negative"));
  CHECK_THAT(after("0.1 0.03", "-0.1 0.03"), StartsWith("a.dump:10: radius: -0.1 m is out of range"));
  CHECK_THAT(after("0.03", "0"), StartsWith("a.dump:10: mass: 0 kg is out of range"));
  CHECK_THAT(after("ATOMS\n2", "ATOMS\n3"), StartsWith("a.dump:") && Contains("the file ends after 2 of 3 rows"));
  CHECK_THAT(after("ATOMS\n2", "ATOMS\n1"), StartsWith("a.dump:11: \"4 1 2.25"));
  CHECK_THAT(after("ATOMS\n2", "ATOMS\n-2"), StartsWith("a.dump:4: -2 rows"));
  CHECK_THAT(after("ATOMS\n2", "ATOMS\n9007199254740992"), Contains("is it cut short?"));
  CHECK_THAT(after("ATOMS\n2", "ATOMS\n1e300"), StartsWith("a.dump:4: NUMBER: \"1e300\" is not a whole number"));
  CHECK_THAT(after("BOUNDS pp", "BOUNDS xy xz yz pp"), StartsWith("a.dump:5: the box is triclinic"));
  CHECK_THAT(after("0 2\n", "0 2 0.1\n"), StartsWith("a.dump:6: 3 numbers bound the box along x"));
  CHECK_THAT(after("0 2\n", "2 0\n"), StartsWith("a.dump:6: the box along x goes from 2 to 0"));
  CHECK_THAT(after(" radius", " rad_"), Contains("has no radii"));
  CHECK_THAT(after("x y z", "x y q"), Contains("column z"));
  CHECK_THAT(after("TIMESTEP\n20", "UNITS\nlj\nITEM: TIMESTEP\n20"), StartsWith("a.dump:2: the file is in units lj"));
  CHECK_THAT(after("BOX BOUNDS", "BOX EDGES"), StartsWith("a.dump:5: \"BOX EDGES pp ff mm\" is unknown"));
  CHECK_THAT(after("ATOMS id", "ENTRIES id"), Contains("holds contacts"));
  for (std::size_t length = 0; length + 10 < dump.size(); length += 7) {  // cut short anywhere
    CHECK_THAT(refusal(dump.substr(0, length), "a.dump"), StartsWith("a.dump"));
  }
}

TEST_CASE("files in a row are taken by the numbers in their names") {
  const TemporaryFolder folder;
  for (const char* step : {"2", "10", "100"}) {
    write_text_file(folder / (std::string("dump_") + step + ".liggghts"),
                    replaced(dump, "\n20\n", std::string("\n") + step + "\n"));
  }
  write_text_file(folder / "dump_100.liggghts.local", "not for this");
  PackingOptions options;
  options.time_step = 1;
  const PackingSeries series({folder / "dump_*"}, options);
  REQUIRE(series.size() == 3);
  CHECK(series.time(0) == 2);
  CHECK(series.time(1) == 10);
  CHECK(series.time(2) == 100);
  CHECK_THROWS_WITH(PackingSeries({folder / "dmp_*"}), Contains("no file has such a name"));
  CHECK_THROWS_WITH(PackingSeries({folder / "dump_3"}), Contains("no such file"));
  CHECK_THROWS_WITH(PackingSeries({folder.path()}), Contains("is not a file"));
}

TEST_CASE("extended XYZ brings box, time and species") {
  const Snapshot s = reading(extended_xyz, "a.xyz");
  CHECK(s.position[1] == Vec3(-0.5, 1, 2));
  CHECK(s.radius == std::vector<double>{0.1, 0.2});
  CHECK(s.groups[0].name == "glass");  // by the alphabet
  CHECK(s.type == std::vector<std::int32_t>{1, 0});
  CHECK(s.fields.at("velocity").values == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(s.domain.min == Vec3(-1, 0, 0));
  CHECK(s.domain.max == Vec3(1, 3, 4));
  CHECK(s.domain.periodic == std::array<bool, 3>{true, false, false});
  CHECK(s.time == 0.5);
  const auto after = [](const std::string& from, const std::string& to) {
    return refusal(replaced(extended_xyz, from, to), "a.xyz");
  };
  CHECK_THAT(after("Properties", "Propertes"), StartsWith("a.xyz:2: plain XYZ has no radii"));
  CHECK_THAT(after("0 3 0", "1 3 0"), StartsWith("a.xyz:2: Lattice: the box is not along the axes"));
  CHECK_THAT(after("0 4\"", "0\""), StartsWith("a.xyz:2: Lattice: 8 numbers"));
  CHECK_THAT(after("0 4\"", "0 -4\""), StartsWith("a.xyz:2: Lattice: a side of -4 m"));
  CHECK_THAT(after("pos:R:3", "pos:R:x"), StartsWith("a.xyz:2: Properties: pos has \"x\" components"));
  CHECK_THAT(after("pos:R:3", "pos:R"), StartsWith("a.xyz:2: Properties:"));
  CHECK_THAT(after("2\n", "3\n"), Contains("the file ends after 2 of 3 rows"));
  CHECK_THAT(after("2\n", "1\n"), StartsWith("a.xyz:4: \"glass"));
  CHECK_THAT(after("0.5 1 2", "0.5 inf 2"), StartsWith("a.xyz:3: y: \"inf\" is not finite"));
}

TEST_CASE("Yade's text brings spheres, ids and materials") {
  const Snapshot plain = reading("#format x_y_z_r\n# by hand\n0.1\t0.2\t0.3\t0.05\n1\t0.2\t0.3\t0.15\n", "a.txt");
  CHECK(plain.position[0] == Vec3(0.1, 0.2, 0.3));
  CHECK(plain.radius == std::vector<double>{0.05, 0.15});
  CHECK(plain.id == std::vector<std::int64_t>{0, 1});
  // Without a box, the one around the spheres.
  CHECK((plain.domain.min - Vec3(0.05, 0.05, 0.15)).norm() < 1e-15);
  CHECK((plain.domain.max - Vec3(1.15, 0.35, 0.45)).norm() < 1e-15);
  CHECK(std::count(plain.notes.begin(), plain.notes.end(), note_no_box) == 1);
  CHECK(std::count(plain.notes.begin(), plain.notes.end(), note_no_density) == 1);
  const Snapshot full = reading("#format id_x_y_z_r_matId\n7 0.1 0.2 0.3 0.05 1\n3 1 0.2 0.3 0.15 0\n", "a.txt");
  CHECK(full.id == std::vector<std::int64_t>{3, 7});
  CHECK(full.type == std::vector<std::int32_t>{0, 1});
  CHECK(reading("0.1 0.2 0.3 0.05\n", "a.txt").size() == 1);
  CHECK(reading("#format x_y_z_r_attrs\n0.1 0.2 0.3 0.05 7 8\n", "a.txt").radius[0] == 0.05);
  CHECK_THAT(refusal("#format x_y_z_r\n0.1 0.2 0.3\n", "a.txt"), StartsWith("a.txt:2: the row has 3 fields"));
  CHECK_THAT(refusal("#format x_y_z_r\n0.1 0,2 0.3 1\n", "a.txt"),
             StartsWith("a.txt:2: y: \"0,2\"") && Contains("comma"));
  CHECK_THAT(refusal("#format x_y_z_r\n0.1 0.2 0.3 1e999\n", "a.txt"), StartsWith("a.txt:2: r:"));
}

TEST_CASE("a table has ids, types and densities where it names them") {
  const Snapshot s = reading("id,x,y,z,radius,type,density,fx\n8,1,2,3,0.5,1,2500,4\n2,4,5,6,0.5,0,1000,5\n", "a.csv");
  CHECK(s.id == std::vector<std::int64_t>{2, 8});
  CHECK(s.position[1] == Vec3(1, 2, 3));
  CHECK(s.groups[1].density == 2500);
  CHECK(s.fields.at("force").values == std::vector<double>{5, 0, 0, 4, 0, 0});
  CHECK_THAT(refusal("x;y;z;radius\n1;2;3;4\n", "a.csv"), StartsWith("a.csv:1:") && Contains("commas stand between"));
  CHECK_THAT(refusal("x,y,z,radius\n0,1,1,1,1\n", "a.csv"), StartsWith("a.csv:2: the row has 5 fields, the header 4"));
  CHECK_THAT(refusal("x,y,z,radius,type,group\n", "a.csv"), StartsWith("a.csv:1: group: means the same as type"));
  CHECK_THAT(refusal("x,y,z,radius,density\n1,1,1,1,-2\n", "a.csv"), StartsWith("a.csv:2: density: -2 kg/m3"));
  CHECK_THAT(refusal("id,x,y,z,radius\n1,1,1,1,1\n1,2,2,2,1\n", "a.csv"), StartsWith("a.csv:3: id: 1 occurs twice"));
  CHECK(reading("x,y,z,radius\n", "a.csv").size() == 0);
}

TEST_CASE("masses of few digits give a group one density") {
  std::string text = "x,y,z,radius,density\n";
  for (const char* density : {"1199.99", "1200.01", "1200"}) text += "1,1,1,1," + std::string(density) + "\n";
  CHECK(reading(text, "a.csv").groups[0].density == Approx(1200).epsilon(1e-12));
}

TEST_CASE("what is no packing is refused, naming what would be one") {
  CHECK_THAT(refusal("title = \"x\"\n", "a.toml"), StartsWith("a.toml: is no packing; expected a run folder,"));
  CHECK_THAT(refusal("", "a.dump"), StartsWith("a.dump: is no packing"));
  CHECK_THAT(refusal("\x1f\x8b\x08", "a.dump.gz"), EndsWith("is compressed; unpack it first"));
  CHECK_THAT(refusal("<?xml version=\"1.0\"?>\n<svg/>", "a.vtu"), StartsWith("a.vtu: "));
  CHECK_THAT(refusal("x", "a.vtkhdf"), Contains("not a readable HDF5 file"));
}

TEST_CASE("rows of any order come into memory as neighbours in space, with all they carry") {
  const TemporaryFolder folder;
  const Snapshot s = random_packing(3000);
  const std::string extension = GENERATE(".dump", ".csv", ".xyz", ".data");
  CAPTURE(extension);
  write_packing(folder / ("a" + extension), s);
  const Snapshot t = read_packing(folder / ("a" + extension));
  write_snapshot(folder / "a.vtkhdf", s);
  CHECK(t.id == read_snapshot(folder / "a.vtkhdf").id);  // along the curve that packstone's own files follow
  CHECK_FALSE(std::is_sorted(t.id.begin(), t.id.end()));
  double apart = 0;
  for (std::size_t i = 1; i < t.size(); ++i) apart += (t.position[i] - t.position[i - 1]).norm();
  CHECK(apart / 3000 < 0.25);  // 0.126 between neighbours of a lattice as dense, 1.2 between two at random
  const Snapshot u = by_id(t);
  CHECK(u.id == s.id);
  CHECK(u.position == s.position);
  CHECK(u.radius == s.radius);
  CHECK(u.type == s.type);
  CHECK(u.material == s.material);
  CHECK(u.fields.at("velocity").values == s.fields.at("velocity").values);
}

TEST_CASE("files of other programs have their rows by id, whatever the order in memory") {
  const TemporaryFolder folder;
  const Snapshot s = random_packing(300);
  const std::string extension = GENERATE(".dump", ".csv", ".xyz", ".data");
  CAPTURE(extension);
  write_packing(folder / ("a" + extension), s);
  write_packing(folder / ("b" + extension), with_rows(s, space_filling_order(s)));
  CHECK(read_text_file(folder / ("a" + extension)) == read_text_file(folder / ("b" + extension)));
}

TEST_CASE("a region of another program's packing holds the spheres that touch it") {
  const TemporaryFolder folder;
  const Snapshot s = random_packing(2000);
  write_packing(folder / "a.csv", s);
  write_packing(folder / "a.vtkhdf", s);
  ReadOptions read;
  read.region = Region{Vec3(-0.2, 0.1, 1), Vec3(0.1, 0.6, 1.5)};
  const auto ids = [&](const char* name) {
    auto found = PackingSeries({folder / name}).snapshot(0, read).id;
    std::sort(found.begin(), found.end());
    return found;
  };
  CHECK(ids("a.csv").size() > 20);
  CHECK(ids("a.csv") == ids("a.vtkhdf"));
}

TEST_CASE("a LAMMPS data file takes spheres with a density only") {
  const TemporaryFolder folder;
  Snapshot s = random_packing(3);
  s.groups[1].density = 0;
  CHECK_THROWS_WITH(write_packing(folder / "a.data", s), Contains("the density of particle 8 is not known"));
  s = random_packing(3);
  s.radius[0] = 0;
  CHECK_THROWS_WITH(write_packing(folder / "a.data", s), Contains("particle 5 has radius 0"));
  s = random_packing(3);
  s.id = {0, 1, 2};
  write_packing(folder / "a.data", s);  // LAMMPS counts from 1
  CHECK(by_id(read_packing(folder / "a.data")).id == std::vector<std::int64_t>{1, 2, 3});
}
