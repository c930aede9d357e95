#include "targets.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "core/checkpoints.hpp"
#include "core/error.hpp"
#include "core/flat_toml.hpp"
#include "core/formats/csv_table.hpp"
#include "core/formats/lammps_data.hpp"
#include "core/formats/lammps_dump.hpp"
#include "core/formats/local_dump.hpp"
#include "core/formats/packing_series.hpp"
#include "core/formats/xyz.hpp"
#include "core/formats/yade_text.hpp"
#include "core/history.hpp"
#include "core/open_snapshot.hpp"
#include "core/particle_view.hpp"
#include "core/run_folder.hpp"
#include "core/scene.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "engine/boundary/mesh_file.hpp"
#include "engine/boundary/surface_shape.hpp"
#include "engine/formula.hpp"
#include "seeds.hpp"
#include "tests/temporary_folder.hpp"

namespace packstone::fuzz {

namespace fs = std::filesystem;
using namespace formats;

namespace {

/// For readers that take files: in memory where the system has such a place.
const fs::path& folder() {
  static const testing::TemporaryFolder made(fs::exists("/dev/shm") ? "/dev/shm" : fs::temp_directory_path());
  return made.path();
}

fs::path file_of(const std::string& input, const std::string& name) {
  const fs::path path = folder() / name;
  std::ofstream(path, std::ios::binary | std::ios::trunc) << input;
  return path;
}

void read_scene_text(const std::string& input) {
  const std::string written = to_toml(parse_scene(input, "scene.toml"));
  std::string again;
  try {
    again = to_toml(parse_scene(written, "written"));
  } catch (const InputError& error) {
    throw std::logic_error(std::string("the scene is refused when it is written and read again: ") + error.what());
  }
  const auto [one, other] = std::mismatch(written.begin(), written.end(), again.begin(), again.end());
  if (one == written.end() && other == again.end()) return;
  throw std::logic_error("the scene is another one when it is written and read again, from here on: " +
                         std::string(one, written.end()).substr(0, 80) + " is " +
                         std::string(other, again.end()).substr(0, 80));
}

void read_csv(const std::string& input) { to_snapshot(read_csv_table(input, "fuzz")); }
void read_data(const std::string& input) { to_snapshot(read_lammps_data(input, "fuzz")); }
void read_yade(const std::string& input) { to_snapshot(read_yade_text(input, "fuzz")); }

void read_dump(const std::string& input) {
  for (const DumpFrame& frame : index_dump(input, "fuzz")) to_snapshot(read_dump_frame(input, "fuzz", frame));
}

void read_extended_xyz(const std::string& input) {
  for (const XyzFrame& frame : index_xyz(input, "fuzz")) to_snapshot(read_xyz_frame(input, "fuzz", frame));
}

/// Beside the particles of the dump that the seeds belong to.
void read_pairs(const std::string& input) {
  static const Snapshot particles = PackingSeries({data_file("peers/liggghts.dump")}).snapshot(0);
  contacts_of_pairs(particles, read_local_dump(file_of(input, "fuzz.local"), particles.step, {}));
}

void read_walls(const std::string& input) {
  static const Snapshot particles = PackingSeries({data_file("liggghts_walls/bed.dump")}).snapshot(0);
  contacts_with_walls(particles, read_wall_dump(file_of(input, "fuzz.wall"), particles.step, {}));
}

/// Whatever the file turns out to be.
void read_any(const std::string& input) {
  const PackingSeries series({file_of(input, "fuzz.dat")});
  for (std::size_t k = 0; k < series.size(); ++k) series.snapshot(k);
}

void read_snapshot_file(const std::string& input) {
  const fs::path path = file_of(input, "fuzz.vtkhdf");
  const Snapshot whole = read_snapshot(path);
  const OpenSnapshot open(path);
  for (const RowChunk& chunk : open.view().chunks) check_rows(open.view(), chunk);
}

void read_history_file(const std::string& input) { read_history(file_of(input, "history.csv")); }

void read_run_record(const std::string& input) {
  file_of(input, "run.json");
  RunReader(folder()).record();
}

void read_checkpoint(const std::string& input) {
  fs::create_directory(folder() / Checkpoints::folder_name);
  file_of(input, std::string(Checkpoints::folder_name) + "/checkpoint_0");
  for (const FoundCheckpoint& found : Checkpoints(folder()).find()) {
    if (!found.fault.empty()) throw InputError(found.fault);
  }
}

void read_view(const std::string& input) { read_flat_toml(file_of(input, "view.toml")); }

void read_formula(const std::string& input) {
  const engine::Formula formula(input, {"x", "y"});
  formula({0.1, -2.0});
}

void read_grid(const std::string& input) { engine::surface_of_grid(file_of(input, "grid.csv").string()); }

void read_amount(const std::string& input) {
  if (!parse_vector(input, unit::metre)) parse_quantity(input, unit::metre);
}

#ifdef PACKSTONE_HAS_VTK
void read_vtk(const std::string& input) {
  read_packing(file_of(input, input.starts_with('#') ? "fuzz.vtk" : "fuzz.vtu"));
}

template <const char* name>
void read_mesh_file(const std::string& input) {
  engine::read_mesh(file_of(input, name).string(), 1, Vec3::Zero());
}

constexpr char stl_name[] = "fuzz.stl", obj_name[] = "fuzz.obj", ply_name[] = "fuzz.ply", vtk_name[] = "fuzz.vtk";
#endif

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"scene", read_scene_text, scene_seeds},
      {"csv", read_csv, csv_seeds},
      {"lammps_data", read_data, data_seeds},
      {"lammps_dump", read_dump, dump_seeds},
      {"local_dump", read_pairs, local_dump_seeds},
      {"wall_dump", read_walls, wall_dump_seeds},
      {"xyz", read_extended_xyz, xyz_seeds},
      {"yade_text", read_yade, yade_seeds},
      {"any_packing", read_any, packing_seeds},
      {"snapshot", read_snapshot_file, snapshot_seeds},
      {"history", read_history_file, history_seeds},
      {"run_record", read_run_record, run_record_seeds},
      {"checkpoint", read_checkpoint, checkpoint_seeds},
      {"view", read_view, view_seeds},
      {"formula", read_formula, formula_seeds},
      {"surface_grid", read_grid, grid_seeds},
      {"quantity", read_amount, quantity_seeds},
#ifdef PACKSTONE_HAS_VTK
      {"vtk", read_vtk, vtk_seeds},
      {"stl", read_mesh_file<stl_name>, stl_seeds},
      {"obj", read_mesh_file<obj_name>, obj_seeds},
      {"ply", read_mesh_file<ply_name>, ply_seeds},
      {"vtk_mesh", read_mesh_file<vtk_name>, vtk_mesh_seeds},
#endif
  };
  return all;
}

const Target& target_named(std::string_view name) {
  std::vector<std::string> names;
  for (const Target& target : targets()) {
    if (target.name == name) return target;
    names.emplace_back(target.name);
  }
  throw std::invalid_argument("there is no target \"" + std::string(name) + "\"; there are: " + joined(names));
}

bool is_accepted(const Target& target, const std::string& input) {
  try {
    target.read(input);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace packstone::fuzz
