#include "seeds.hpp"

#include "core/checkpoints.hpp"
#include "core/checksums.hpp"
#include "core/files.hpp"
#include "core/formats/packing_output.hpp"
#include "core/run_folder.hpp"
#include "core/snapshot.hpp"
#include "tests/sample_scene.hpp"
#include "tests/temporary_folder.hpp"

namespace packstone::fuzz {

namespace fs = std::filesystem;

namespace {

Seeds files(const std::vector<std::string>& names) {
  Seeds seeds;
  for (const std::string& name : names) seeds.push_back(read_text_file(data_file(name)));
  return seeds;
}

/// Three spheres over a floor, two of them in contact.
Snapshot small_packing() {
  Snapshot s;
  s.time = 0.5;
  s.step = 100;
  s.domain = {Vec3::Zero(), Vec3::Ones(), {true, true, false}};
  s.gravity = Vec3(0, 0, -9.8);
  s.position = {{0.2, 0.2, 0.1}, {0.39, 0.2, 0.1}, {0.7, 0.5, 0.4}};
  s.radius = {0.1, 0.1, 0.05};
  s.id = {0, 1, 2};
  s.type = {0, 0, 1};
  s.material = {0, 0, 1};
  s.fields["velocity"] = {3, "m/s", std::vector<double>(9, 0.25)};
  s.groups = {{"large", "glass", 2500}, {"small", "steel", 7800}};
  s.material_names = {"glass", "steel"};
  s.boundaries = {{"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}};
  s.boundaries.push_back({"plate", "mesh"});
  s.boundaries.back().points = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
  s.boundaries.back().triangles = {{0, 1, 2}};
  s.contacts = Contacts{{0, 0},
                        {1, -1},
                        {{1, 0, 0}, {0, 0, 2}},
                        {-Vec3::UnitX(), Vec3::UnitZ()},
                        {0.01, 0.001},
                        {{0.3, 0.2, 0.1}, {0.2, 0.2, 0}},
                        {0, 1}};
  s.scene_text = "title = \"small\"\n";
  s.scene_hash = "0123456789abcdef";
  s.program = "packstone 0.0.0 (git 0000000)";
  return s;
}

/// small_packing as a file of that format.
std::string written_as(const std::string& extension) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder / ("small" + extension);
  write_packing(path, small_packing());
  return read_text_file(path);
}

Seeds and_more(Seeds seeds, const Seeds& more) {
  seeds.insert(seeds.end(), more.begin(), more.end());
  return seeds;
}

}  // namespace

fs::path data_file(const std::string& name) { return fs::path(PACKSTONE_SOURCE_DIR) / "tests/data" / name; }

Seeds scene_seeds() {
  Seeds seeds = {testing::small_scene};
  for (const auto& sample : fs::directory_iterator(fs::path(PACKSTONE_SOURCE_DIR) / "samples")) {
    const fs::path scene = sample.path() / "scene.toml";
    if (fs::exists(scene)) seeds.push_back(read_text_file(scene));
  }
  return seeds;
}

Seeds csv_seeds() { return {written_as(".csv"), "x,y,z,radius\n0,0,0,1\n1.9,0,0,1e0\n"}; }
Seeds data_seeds() { return and_more(files({"lammps_sphere.data", "peers/bed.data"}), {written_as(".data")}); }
Seeds dump_seeds() { return and_more(files({"peers/lammps.dump", "liggghts_walls/bed.dump"}), {written_as(".dump")}); }
Seeds local_dump_seeds() { return files({"peers/liggghts.dump.local"}); }
Seeds wall_dump_seeds() { return files({"liggghts_walls/bed.dump.wall"}); }
Seeds xyz_seeds() { return {written_as(".xyz")}; }
Seeds yade_seeds() { return files({"yade/bed.txt", "yade/bed_attrs.txt", "yade/bed_id.txt", "yade/bed_material.txt"}); }
Seeds packing_seeds() { return {written_as(".csv"), written_as(".dump"), written_as(".xyz"), written_as(".data")}; }

/// With and without the checksums that keep damaged files from the rest of the reader.
Seeds snapshot_seeds() {
  const std::string bytes = written_as(".vtkhdf");
  const std::size_t sums = Checksums::behind(bytes)->text().size();
  return {bytes, bytes.substr(0, bytes.size() - sums), files({"snapshot_planes_only.vtkhdf"}).front()};
}

Seeds history_seeds() { return {"step,time,elastic\n0,0,1e-3\n10,0.1,2.5\n20,0.2,nan\n", "step\n"}; }

Seeds run_record_seeds() {
  const testing::TemporaryFolder folder;
  RunRecord record;
  record.title = "small";
  record.warnings = {"one"};
  RunWriter(folder / "run", false).write_record(record);
  return {read_text_file(folder / "run" / "run.json")};
}

Seeds checkpoint_seeds() {
  const testing::TemporaryFolder folder;
  std::vector<double> numbers = {0.5, -1.5, 1e300};
  std::string word = "state";
  Checkpoints(folder.path()).write({{0, 100, 0.5}, "packstone", "seed = 1\n"}, [&](Archive& a) {
    a.begin("numbers");
    a(numbers, word);
  });
  return {read_text_file(folder / "checkpoint/checkpoint_0")};
}

Seeds view_seeds() {
  return {"color = \"speed\"\nsize = \"320x240\"\nsupersampling = 2\narrows = true\ncut = [\"x>0\", \"y<1\"]\n"};
}

Seeds formula_seeds() {
  return {"0.1*sin(2*pi*x) + y^2", "x<1 ? mod(x, 2) : floor(y)", "max(x, min(y, 3e-2), (x))", "-(-(x))"};
}

Seeds grid_seeds() { return {"x,y,z\n0,0,0\n0,1,0.1\n1,0,0.2\n1,1,0.3\n"}; }
Seeds quantity_seeds() { return {"20 mm", "1e-3", "0.1,20 mm,0"}; }

Seeds vtk_seeds() {
  return and_more(files({"yade/bed-spheres-00000000.vtk", "yade/bed-spheres.60000.vtu"}),
                  {written_as(".vtu"), written_as(".vtp")});
}

Seeds stl_seeds() { return files({"liggghts_walls/floor.stl"}); }
Seeds obj_seeds() {
  return {
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 2/1/1 4/2/1 "
      "3/3/1\n"};
}

Seeds ply_seeds() {
  return {
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"};
}

Seeds vtk_mesh_seeds() {
  return {
      "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n"
      "POLYGONS 1 5\n4 0 1 3 2\n"};
}

}  // namespace packstone::fuzz
