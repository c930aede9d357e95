// What of a run folder can be used, whatever has happened to it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/checkpoints.hpp"
#include "core/run_folder.hpp"

namespace packstone {

/// A file that cannot be used, and why.
struct FileFault {
  std::filesystem::path file;
  std::string what;
};

struct RunFolderState {
  std::optional<RunRecord> record;               ///< run.json, where it can be read
  bool at_work = false;                          ///< a process runs into the folder
  std::vector<std::filesystem::path> snapshots;  ///< that open, in order
  std::vector<double> times;                     ///< of these [s]
  std::size_t history_rows = 0;
  double history_end = 0;  ///< time of the last row [s]
  std::vector<FoundCheckpoint> checkpoints;
  std::vector<FileFault> faults;  ///< of all but checkpoints, which tell their own

  /// The process that ran into the folder has ended without a word.
  bool is_orphaned() const { return record && record->status == RunStatus::running && !at_work; }
};

/// Never throws for a damaged file.
RunFolderState state_of_run(const std::filesystem::path& folder);

}  // namespace packstone
