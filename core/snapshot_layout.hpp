// Where things stand in a snapshot file (docs/format.md), for those who read it in different ways.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/hdf5.hpp"
#include "core/particle_view.hpp"

namespace packstone {

inline constexpr const char* snapshot_points = "/VTKHDF/Points";

/// Dataset of a column of the particles, "radius".
std::string snapshot_column(const std::string& name);

/// The columns that not every snapshot has: Snapshot::fields.
std::vector<std::string> field_names(const hdf5::Reader& file);

/// Of the file's instant [s]. Throws InputError where it is not a number.
double read_time(const hdf5::Reader& file);

/// Rows of all the particles' columns. Throws InputError where they differ in length.
std::size_t read_row_count(const hdf5::Reader& file);

/// The chunks that the rows of a file stand in. Throws InputError where they are not of all rows.
std::vector<RowChunk> read_chunks(const hdf5::Reader& file, std::size_t rows);

}  // namespace packstone
