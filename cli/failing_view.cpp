#include "cli/failing_view.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/snapshot.hpp"

namespace packstone::cli {

namespace {

void take_failing_states(RenderCall& call) {
  for (std::filesystem::path& path : call.paths) {
    if (!std::filesystem::is_directory(path)) continue;
    const std::filesystem::path state = path / failing_state_name;
    if (!std::filesystem::exists(state)) {
      throw InputError(fmt::format("--failure: {} holds no {}: the run was not stopped by its monitor", path.string(),
                                   failing_state_name));
    }
    path = state;
  }
}

bool is_failing_state(const std::filesystem::path& path) {
  return std::filesystem::is_regular_file(path) && path.extension() == ".vtkhdf" &&
         RunReader(path).open(0).view().fields.contains(offender_field);
}

/// Ids of the marked particles, "17,23".
std::string marked_in(const std::filesystem::path& path) {
  const Snapshot snapshot = read_snapshot(path, {.region = {}, .contacts = false});
  const std::vector<double>& mark = snapshot.fields.at(offender_field).values;
  std::string ids;
  for (std::size_t row = 0; row < snapshot.size(); ++row) {
    if (mark[row] > 0) ids += fmt::format("{}{}", ids.empty() ? "" : ",", snapshot.id[row]);
  }
  return ids;
}

}  // namespace

void show_failure(RenderCall& call) {
  if (call.failure) take_failing_states(call);
  if (!call.picture.color.empty() || !std::all_of(call.paths.begin(), call.paths.end(), is_failing_state)) return;
  call.picture.color = offender_field;
  OverlayCall& overlay = call.overlay;
  const bool draws = overlay.contacts || overlay.chains || !overlay.arrows.empty() || !overlay.trajectories.empty();
  if (call.paths.size() > 1 || draws || !overlay.particles.empty()) return;
  const std::string marked = marked_in(call.paths.front());
  if (marked.empty()) return;
  overlay.particles = "shrunk";
  overlay.trajectories = marked;  // whose particles keep their size; one instant draws no way
}

}  // namespace packstone::cli
