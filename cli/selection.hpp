// Which snapshots of a run a verb works on.
#pragma once

#include <string>
#include <vector>

#include "core/run_folder.hpp"

namespace packstone::cli {

/// Indices named by "last", "first", "all", a number, or "t=SECONDS". Throws InputError.
std::vector<std::size_t> selected_snapshots(const RunReader& run, const std::string& at);

/// Indices of a range "a:b:s", "a:b", or one number; ends may be left out or negative; b is included.
/// Throws InputError for a malformed range or a number that does not exist.
std::vector<std::size_t> frame_range(const RunReader& run, const std::string& range);

}  // namespace packstone::cli
