// Good inputs of every reader: the files of tests/data and of the samples, and small ones made here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace packstone::fuzz {

using Seeds = std::vector<std::string>;

/// Of tests/data.
std::filesystem::path data_file(const std::string& name);

Seeds scene_seeds();
Seeds csv_seeds();
Seeds data_seeds();
Seeds dump_seeds();
Seeds local_dump_seeds();
Seeds wall_dump_seeds();
Seeds xyz_seeds();
Seeds yade_seeds();
Seeds packing_seeds();
Seeds snapshot_seeds();
Seeds history_seeds();
Seeds run_record_seeds();
Seeds checkpoint_seeds();
Seeds view_seeds();
Seeds formula_seeds();
Seeds grid_seeds();
Seeds quantity_seeds();
Seeds vtk_seeds();
Seeds stl_seeds();
Seeds obj_seeds();
Seeds ply_seeds();
Seeds vtk_mesh_seeds();

}  // namespace packstone::fuzz
