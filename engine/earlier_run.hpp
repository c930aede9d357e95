// What an earlier run left in a folder for another to go on from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/checkpoints.hpp"
#include "core/run_folder.hpp"
#include "core/scene.hpp"

namespace packstone::engine {

struct EarlierRun {
  RunRecord record;
  std::optional<FoundCheckpoint> checkpoint;  ///< the newest whole one; none: begin anew
  bool finished = false;
};

/// This build: others make other bits of the same state, or hold it in another way.
std::string program_fingerprint();

/// Throws InputError where the run there is of another scene, still at work, or cannot be gone on with: all its
/// checkpoints are damaged or another build's.
EarlierRun find_earlier_run(const Scene& scene, const std::filesystem::path& folder);

/// Of two texts, as to_toml writes them; run: of what is in the folder. Throws InputError that names the keys in which
/// they differ.
void refuse_other_scene(const std::string& given, const std::string& run, const std::filesystem::path& folder);

/// The scene of the folder's run, as it was given, with overrides as read_scene takes them. Throws InputError where no
/// whole checkpoint tells it.
Scene scene_of_earlier_run(const std::filesystem::path& folder, const std::vector<std::string>& overrides);

}  // namespace packstone::engine
