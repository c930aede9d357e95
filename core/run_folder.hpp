// The folder a run leaves behind: scene.toml, run.json, history.csv, snapshots/ (docs/format.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.hpp"
#include "core/folder_lock.hpp"
#include "core/formats/packing_series.hpp"
#include "core/history.hpp"
#include "core/open_snapshot.hpp"
#include "core/run_verdict.hpp"
#include "core/snapshot.hpp"

namespace packstone {

/// How far a run got.
enum class RunStatus { running, finished, failed, interrupted };

const char* to_string(RunStatus status);

/// Of a run folder that the monitor stopped: a snapshot with the field `offender`.
inline constexpr const char* failing_state_name = "failure.vtkhdf";

/// run.json: where the data come from.
struct RunRecord {
  std::string title;
  std::string version;
  std::string git_revision;
  std::string compiler;
  std::string machine;
  std::string scene_hash;
  std::string filling_hash;  ///< of the file the particles came from; empty for growth
  std::uint64_t seed = 0;
  int threads = 1;
  RunStatus status = RunStatus::running;
  std::string reason;                   ///< why it failed or was interrupted
  std::optional<RunVerdict> failure{};  ///< why the monitor stopped it
  std::vector<RunVerdict> doubts{};     ///< why a run that went on is not to be trusted
  std::vector<std::string> warnings;
  double wall_seconds = 0;
  double loop_seconds = 0;       ///< of it in time steps, lists of neighbours included
  double list_seconds = 0;       ///< of that in building them
  std::int64_t list_builds = 0;  ///< how often the neighbour list was built
  double processor_seconds = 0;  ///< of the whole run on all of its threads; 0: an older run
  std::int64_t steps = 0;
  std::int64_t integrator_steps = 0;  ///< of overdamped motion
  std::string ending;                 ///< of overdamped motion: whether at rest
  std::int64_t particles = 0;
  std::int64_t process = 0;  ///< its number and machine while it runs
  std::string host;
};

/// What becomes of an earlier run in the folder of another.
enum class FolderUse { refuse, replace, go_on };

/// Whether the folder holds a run, that of a process killed while it began included.
bool holds_run(const std::filesystem::path& folder);
/// run.json. Throws InputError when it cannot be read.
RunRecord read_record(const std::filesystem::path& folder);
/// The snapshots of a run folder, in order.
std::vector<std::filesystem::path> snapshot_files(const std::filesystem::path& folder);

/// Reading side: a run folder, or files of packings of any program (PackingSeries) seen as a run.
class RunReader {
 public:
  /// Throws InputError when path is neither a run folder nor a file, or files, that hold packings.
  explicit RunReader(const std::filesystem::path& path, const PackingOptions& options = {});
  /// Several paths are the files of one series.
  RunReader(const std::vector<std::filesystem::path>& paths, const PackingOptions& options);

  const std::filesystem::path& path() const { return path_; }
  bool is_folder() const { return is_folder_; }
  std::size_t snapshot_count() const { return files_.size(); }
  const std::vector<std::filesystem::path>& snapshot_files() const { return files_; }
  /// Time of every snapshot [s], ascending; 0 where another program's file does not say it.
  const std::vector<double>& times() const { return times_; }
  Snapshot snapshot(std::size_t index, const ReadOptions& options = {}) const;
  /// The particles of a snapshot where they lie, without contacts.
  OpenSnapshot open(std::size_t index) const;
  /// Index from "last", "first", a number (negative counts from the end) or "t=SECONDS" (nearest).
  /// Throws InputError where there is none, as for a time half an interval or more before the first or after the last.
  std::size_t index_at(const std::string& where) const;
  /// Empty for files.
  RunRecord record() const;
  std::string scene_text() const;
  History history() const;

 private:
  std::filesystem::path path_;
  bool is_folder_ = false;
  std::shared_ptr<const PackingSeries> series_;  // shared: readers are copied
  std::vector<std::filesystem::path> files_;
  std::vector<double> times_;
};

/// Writing side. Every file is written under another name and renamed, history.csv excepted: it grows by whole lines.
class RunWriter {
 public:
  /// Creates the folder, or opens one that holds a run, and keeps others out. Throws InputError when it cannot be made
  /// or written, or another process runs into it.
  RunWriter(const std::filesystem::path& path, FolderUse use);
  RunWriter(const std::filesystem::path& path, bool overwrite)
      : RunWriter(path, overwrite ? FolderUse::replace : FolderUse::refuse) {}

  void write_scene(const std::string& text) const;
  void write_record(const RunRecord& record) const;
  void write_snapshot(const Snapshot& snapshot);
  /// The state in which the run was stopped, beside the series, of which it is no part.
  void write_failing_state(const Snapshot& snapshot) const;
  /// The first row fixes the columns.
  void append_history(const std::vector<std::string>& columns, const std::vector<double>& row);

  /// How much has been written.
  void archive(Archive& a);
  /// Of a run that goes on: leaves in history.csv what has been written by then. Snapshots that came after are written
  /// over, with the same bytes. Throws RunError where history.csv holds less.
  void cut_history() const;
  /// Has the disk take the history, as it has the snapshots: a checkpoint must not outlast what it counts.
  void sync() const;

  const std::filesystem::path& path() const { return path_; }

 private:
  void write_series() const;

  std::filesystem::path path_;
  FolderLock lock_;
  std::vector<double> times_;  ///< of the snapshots [s]
  std::uint64_t history_size_ = 0;
};

}  // namespace packstone
