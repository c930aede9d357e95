#include "core/run_folder_state.hpp"

#include <functional>

#include "core/error.hpp"
#include "core/folder_lock.hpp"

namespace packstone {

RunFolderState state_of_run(const std::filesystem::path& folder) {
  RunFolderState state;
  const auto look_at = [&](const std::filesystem::path& file, const std::function<void()>& look) {
    try {
      look();
    } catch (const std::exception& error) {
      state.faults.push_back({file, error.what()});
    }
  };
  state.at_work = FolderLock::is_held(folder);
  look_at(folder / "run.json", [&] { state.record = read_record(folder); });
  for (const auto& file : snapshot_files(folder)) {
    look_at(file, [&] {
      const PackingSeries one({file});
      state.times.push_back(one.time(0));
      state.snapshots.push_back(file);
    });
  }
  const std::filesystem::path rows = folder / "history.csv";
  if (std::filesystem::exists(rows)) {
    look_at(rows, [&] {
      const History history = read_history(rows);
      state.history_rows = history.rows();
      if (history.rows() > 0) state.history_end = history.column("time").back();
    });
  }
  state.checkpoints = Checkpoints(folder).find();
  return state;
}

}  // namespace packstone
