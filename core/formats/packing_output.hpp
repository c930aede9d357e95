// Packings written for other programs.
#pragma once

#include <filesystem>
#include <string>

#include "core/snapshot.hpp"

namespace packstone {

/// The extensions that are written, for messages and help.
inline constexpr const char* writable_formats =
    ".vtkhdf (snapshot), .dump, .lammpstrj or .liggghts (LAMMPS text dump), .data (LAMMPS data file), .csv, .xyz or "
    ".extxyz (extended XYZ), .vtu, .vtp, or a folder (run)";

/// Whether a file of this extension holds several instants.
bool holds_series(const std::filesystem::path& path);

/// Writes the snapshot in the format of the path's extension, particles by ascending id (those of packstone's own along
/// a curve through space), so that the rows of successive instants agree; at the end of the file when append is set,
/// which takes a format that holds series. Throws InputError for another extension or a snapshot that the format cannot
/// hold, and RunError when the disk refuses.
void write_packing(const std::filesystem::path& path, const Snapshot& snapshot, bool append = false);

}  // namespace packstone
