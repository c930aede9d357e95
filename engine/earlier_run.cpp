#include "engine/earlier_run.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/scene_difference.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "engine/simd/lanes.hpp"

namespace packstone::engine {

std::string program_fingerprint() {
  return fmt::format("packstone {} (git {}, {}, {} lanes)", version(), git_revision(), compiler(),
                     simd::WidestSingle::width);
}

void refuse_other_scene(const std::string& given, const std::string& run, const std::filesystem::path& folder) {
  const std::vector<std::string> keys = differing_keys(given, run);
  if (keys.empty()) return;
  throw InputError(
      fmt::format("{}: the run there is of another scene; it differs in {}. Name no scene to go on with "
                  "that run, or another folder with -o",
                  folder.string(), joined(keys)));
}

Scene scene_of_earlier_run(const std::filesystem::path& folder, const std::vector<std::string>& overrides) {
  const auto checkpoint = Checkpoints::newest(Checkpoints(folder).find());
  if (!checkpoint) {
    throw InputError(folder.string() + ": holds no whole checkpoint to go on from; name the scene to begin anew");
  }
  return parse_scene(checkpoint->head.scene, checkpoint->file.string(), overrides);
}

EarlierRun find_earlier_run(const Scene& scene, const std::filesystem::path& folder) {
  EarlierRun earlier;
  if (!holds_run(folder)) return earlier;
  const FolderLock nobody_is_at_work(folder);
  try {
    earlier.record = read_record(folder);
    earlier.finished = earlier.record.status == RunStatus::finished;
  } catch (const InputError&) {
    // Missing or damaged: the checkpoint tells all that is needed.
  }
  const std::vector<FoundCheckpoint> found = Checkpoints(folder).find();
  earlier.checkpoint = Checkpoints::newest(found);
  if (!earlier.checkpoint && !found.empty() && !earlier.finished) {
    throw InputError(found.front().fault + "; no other is whole: begin anew with --overwrite");
  }
  if (!earlier.checkpoint) return earlier;
  const CheckpointHead& head = earlier.checkpoint->head;
  refuse_other_scene(to_toml(scene), head.scene, folder);
  if (earlier.finished) return earlier;
  if (head.program != program_fingerprint()) {
    throw InputError(
        fmt::format("{}: written by {}; this is {}, which would go on with other bits. Go on with that "
                    "build, or begin anew with --overwrite",
                    earlier.checkpoint->file.string(), head.program, program_fingerprint()));
  }
  return earlier;
}

}  // namespace packstone::engine
