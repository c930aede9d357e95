// Trials of a study. Its runs are kept in folders, so that a study goes on where it was stopped.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/scene.hpp"

namespace packstone::cli {

/// One run and what was measured of its last snapshot, or one picture or measurement of a packing.
struct Trial {
  bool finished = false;
  std::string reason;                             ///< why it failed
  double seconds = 0;                             ///< of processor time, on all threads
  double particle_steps = 0;                      ///< particles times steps; 0 of what takes none
  std::map<std::string, double> values;           ///< by quantity, "packing.bulk_fraction"; those that have a value
  std::map<std::string, std::string> units = {};  ///< of them; empty for a pure number
  double memory = 0;                              ///< most that it took [B]; 0: not known
};

struct TrialCall {
  std::vector<std::string> quantities;  ///< "MEASURE.QUANTITY"
  int threads = 0;                      ///< 0: as many as the machine has
  std::function<bool()> should_stop;
};

/// A label as part of a file's name: letters, digits, points, dashes and underscores.
std::string file_name_of(const std::string& label);

/// "packing.bulk_fraction" of itself or of a short name, "packing_fraction". Throws InputError for an unknown one.
std::string quantity_of(const std::string& name);

/// Runs the scene into a folder of its own below another, named by label and scene, unless this build has done so
/// already. A run that the monitor stops is a result. Throws InputError and Interrupted.
Trial run_trial(const Scene& scene, const std::string& label, const std::filesystem::path& below,
                const TrialCall& call);

}  // namespace packstone::cli
