// Text dumps of LAMMPS and LIGGGHTS, one frame or several in a file: https://docs.lammps.org/dump.html, styles custom,
// atom and local.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/number_rows.hpp"
#include "core/formats/particle_columns.hpp"
#include "core/formats/text_output.hpp"

namespace packstone::formats {

/// What stands above a frame's rows, and where the rows are.
struct DumpFrame {
  std::int64_t step = 0;
  std::optional<double> time;        ///< where the program wrote it (dump_modify time) [s]
  std::size_t count = 0;             ///< rows
  bool local = false;                ///< rows are contacts (ITEM: ENTRIES), not particles
  Domain box;                        ///< [m]
  std::vector<std::string> columns;  ///< as the file names them
  std::size_t first_byte = 0;        ///< of the rows
  std::int64_t first_line = 0;
};

/// Whether the text begins as a dump does.
bool is_lammps_dump(std::string_view text);

/// The frames in the order of the file. Throws InputError "FILE:LINE: what; what would be right" for a file cut short,
/// a tilted box, units other than si, and what is no dump.
std::vector<DumpFrame> index_dump(std::string_view text, const std::string& source);

/// The particles of a frame; scaled and unwrapped coordinates (xs, xu, xsu) come as positions. A frame of the index
/// above, of the same text. Throws InputError as above; also where a column that is needed is missing.
ParticleColumns read_dump_frame(std::string_view text, const std::string& source, const DumpFrame& frame);

/// Adds the snapshot as a frame. Numbers have the digits that bring them back to the last bit. Throws RunError when the
/// disk refuses.
void write_lammps_dump(TextOutput& out, const Snapshot& snapshot);

}  // namespace packstone::formats
