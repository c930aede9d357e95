// Extended XYZ, one frame or several in a file: https://github.com/libAtoms/extxyz, as ASE and OVITO write it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/number_rows.hpp"
#include "core/formats/particle_columns.hpp"
#include "core/formats/text_output.hpp"
#include "core/snapshot.hpp"

namespace packstone::formats {

/// What stands above a frame's rows, and where the rows are.
struct XyzFrame {
  std::size_t count = 0;
  std::optional<double> time;  ///< Time=, in s
  std::int64_t step = 0;       ///< Step= or Timestep=
  std::optional<Domain> box;   ///< Lattice=, Origin=, pbc=
  std::vector<RowColumn> columns;
  std::size_t first_byte = 0;  ///< of the rows
  std::int64_t first_line = 0;
};

/// Whether the first line is a whole number alone.
bool is_xyz(std::string_view text);

/// The frames in the order of the file. Lengths are in m. Throws InputError "FILE:LINE: what; what would be right" for
/// a file cut short, a lattice that is not along the axes, and plain XYZ, which has no radii.
std::vector<XyzFrame> index_xyz(std::string_view text, const std::string& source);

/// The particles of a frame of the index above. Species name the types; a column type numbers them from 0.
ParticleColumns read_xyz_frame(std::string_view text, const std::string& source, const XyzFrame& frame);

/// Adds the snapshot as a frame; numbers come back to the last bit. Throws RunError when the disk refuses.
void write_xyz(TextOutput& out, const Snapshot& snapshot);

}  // namespace packstone::formats
