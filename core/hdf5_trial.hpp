// HDF5 files that nothing vouches for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace packstone::hdf5 {

/// HDF5 1.10 may crash on a damaged file. Goes through all of its structure in a process of its own, and through the
/// data that are not mere numbers in a row. Returns what ended that; empty where it came to the end, whatever HDF5
/// said.
std::string failure_in_hdf5_trial(const std::filesystem::path& path, std::uintmax_t file_size);

}  // namespace packstone::hdf5
