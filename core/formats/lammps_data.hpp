// LAMMPS data files of atom_style sphere: https://docs.lammps.org/read_data.html, write_data.html.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/formats/particle_columns.hpp"
#include "core/snapshot.hpp"

namespace packstone::formats {

/// A LAMMPS data file counts its atoms near the top: "4 atoms".
bool is_lammps_data(std::string_view text);

/// Columns id, type, radius, density, x, y, z, and vx to wz where the file has Velocities. Units si; image flags,
/// coefficients and other sections are not used. The file does not say which sides of its box are periodic: none is.
/// Throws InputError "SOURCE:LINE: what; what would be right".
ParticleColumns read_lammps_data(std::string_view text, const std::string& source);

/// Writes type, diameter, density and position, and velocities where the snapshot has any. LAMMPS counts atoms from 1:
/// when an id is 0 all are written one higher.
/// Throws InputError where a density is not known or a radius is 0, RunError when the disk refuses.
void write_lammps_data(const std::filesystem::path& path, const Snapshot& snapshot);

}  // namespace packstone::formats
