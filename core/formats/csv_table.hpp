// Tables of particles with a header line, as spreadsheets and scripts write them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/formats/particle_columns.hpp"
#include "core/snapshot.hpp"

namespace packstone::formats {

/// Whether the first line that says something has commas and a column x.
bool is_csv_table(std::string_view text);

/// A header line out of x, y, z, radius (needed), id, type or group, density, vx, vy, vz, wx, wy, wz, fx, fy, fz in any
/// order; SI units. Types count from 0. Throws InputError "SOURCE:LINE: column: what; what would be right".
ParticleColumns read_csv_table(std::string_view text, const std::string& source);

/// Writes id, type, x, y, z, radius, density where it is known, and the vectors the snapshot has. Numbers have the
/// digits that bring them back to the last bit. Throws RunError when the disk refuses.
void write_csv_table(const std::filesystem::path& path, const Snapshot& snapshot);

}  // namespace packstone::formats
