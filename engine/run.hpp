// A scene run into a run folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/run_folder.hpp"
#include "core/scene.hpp"

namespace packstone::engine {

struct RunControl {
  int threads = 0;          ///< 0: as many as the machine has
  bool overwrite = false;   ///< replace an earlier run in the folder
  bool checkpoints = true;  ///< none: a run that is stopped cannot be gone on with
  bool resume = false;      ///< go on with an earlier run in the folder; begin where there is none
  std::function<void(const std::string&)> warn;
  std::function<void(const std::string&)> note;  ///< from where a run goes on
  std::function<void(std::int64_t step, std::int64_t steps, double time)> progress;
  std::function<bool()> should_stop;
};

/// Runs and returns the record that run.json holds at the end. Nothing is written before the scene has been checked.
/// Throws InputError, RunError or Interrupted; run.json then tells which and why, and every snapshot written stays.
/// A run that goes on leaves the same snapshots, history and last checkpoint as one that was never stopped, byte for
/// byte. Refused with InputError: another scene than the folder's, checkpoints that are all damaged or of another
/// build.
RunRecord run_scene(const Scene& scene, const std::filesystem::path& folder, const RunControl& control);

}  // namespace packstone::engine
