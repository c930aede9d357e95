// The measures of many snapshots, several at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/result.hpp"
#include "core/run_folder.hpp"

namespace packstone::analysis {

struct SeriesOptions {
  std::vector<std::string> only;  ///< measures; empty: all but those on request
  Options measure = {};
  std::vector<std::int64_t> trajectories = {};     ///< ids of particles whose way the course tells
  std::function<void(std::size_t)> progress = {};  ///< called with the number of snapshots done, one call at a time
};

/// The measures of the snapshots with these indices. Of several snapshots each thread measures one at a time, so that
/// at most as many as there are threads are in memory; the numbers are the same for any number of threads. Of several
/// snapshots in order of time the last has the measure "course" too, where it is selected.
/// Throws InputError as analyze() does, that of the first snapshot that fails.
std::vector<TimedResults> analyze_series(const RunReader& run, std::span<const std::size_t> indices,
                                         const SeriesOptions& options);

}  // namespace packstone::analysis
