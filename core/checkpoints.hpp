// The checkpoints of a run folder: two in turn, so that one is whole whatever happens while the other is written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.hpp"
#include "core/checkpoint_file.hpp"
#include "core/run_moment.hpp"

namespace packstone {

/// What a checkpoint is of.
struct CheckpointHead {
  RunMoment moment;
  std::string program;  ///< that wrote it; no other makes the same bits of it
  std::string scene;    ///< as it was given, "auto" not replaced

  void archive(Archive& a) { a(moment, program, scene); }
};

/// A checkpoint as it is found.
struct FoundCheckpoint {
  std::filesystem::path file;
  CheckpointHead head;
  std::string fault;  ///< why it is of no use; empty for a whole one
};

class Checkpoints {
 public:
  explicit Checkpoints(const std::filesystem::path& run_folder) : folder_(run_folder / folder_name) {}

  /// Whether there is one, whole or not.
  bool any() const { return std::filesystem::exists(file(0)) || std::filesystem::exists(file(1)); }
  /// Those that are there, read to their ends.
  std::vector<FoundCheckpoint> find() const;
  /// The whole one that is farthest.
  static std::optional<FoundCheckpoint> newest(const std::vector<FoundCheckpoint>& found);

  /// From which the run goes on: the next is written beside it.
  void keep(const FoundCheckpoint& checkpoint);

  /// In place of the older one. Throws RunError when the disk refuses.
  void write(CheckpointHead head, const std::function<void(Archive&)>& state);

  static constexpr const char* folder_name = "checkpoint";

 private:
  static constexpr int count = 2;
  std::filesystem::path file(int k) const { return folder_ / ("checkpoint_" + std::to_string(k)); }

  std::filesystem::path folder_;
  int next_ = 0;
};

}  // namespace packstone
