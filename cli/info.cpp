// packstone info: what a run folder or a snapshot is, and the reference of the scene's keys.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/run_folder.hpp"
#include "core/run_folder_state.hpp"
#include "core/run_verdict_json.hpp"
#include "core/scene.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

using nlohmann::ordered_json;

struct InfoOptions {
  std::filesystem::path path;
  std::string scene_reference;
  bool json = false;
};

/// What a snapshot holds.
ordered_json describe_snapshot(const Snapshot& s) {
  ordered_json fields = ordered_json::array({"radius", "id", "type", "material"});
  for (const auto& [name, field] : s.fields) fields.push_back(name);
  ordered_json groups = ordered_json::array();
  for (std::size_t g = 0; g < s.groups.size(); ++g) {
    const auto count = std::count(s.type.begin(), s.type.end(), static_cast<std::int32_t>(g));
    groups.push_back({{"name", s.groups[g].name},
                      {"material", s.groups[g].material},
                      {"density", s.groups[g].density},
                      {"count", count}});
  }
  ordered_json j = {{"particles", s.size()},
                    {"groups", groups},
                    {"fields", fields},
                    {"contacts", s.contacts ? ordered_json(s.contacts->size()) : ordered_json(nullptr)},
                    {"domain_min", {s.domain.min[0], s.domain.min[1], s.domain.min[2]}},
                    {"domain_max", {s.domain.max[0], s.domain.max[1], s.domain.max[2]}},
                    {"periodic", s.domain.periodic}};
  if (!s.notes.empty()) j["notes"] = s.notes;
  return j;
}

/// run.json, and what its process has come to.
void describe_record(const RunRecord& r, const RunFolderState& state, ordered_json& j) {
  j["title"] = r.title;
  j["status"] = state.is_orphaned() ? "killed" : to_string(r.status);
  if (state.is_orphaned()) {
    j["reason"] = fmt::format("its process, {} on {}, is gone and has not said why: killed, or the machine stopped",
                              r.process, r.host);
  } else if (r.status == RunStatus::running) {
    j["process"] = fmt::format("{} on {}", r.process, r.host);
  }
  if (!r.reason.empty()) j["reason"] = r.reason;
  if (r.failure) j["failure"] = to_json(*r.failure);
  for (const RunVerdict& doubt : r.doubts) j["doubts"].push_back(to_json(doubt));
  j["particles"] = r.particles;
  j["steps"] = r.steps;
  j["wall_seconds"] = r.wall_seconds;
  j["threads"] = r.threads;
  j["seed"] = r.seed;
  j["scene_hash"] = r.scene_hash;
  j["program"] = fmt::format("packstone {} (git {}, {})", r.version, r.git_revision, r.compiler);
  j["machine"] = r.machine;
  if (!r.warnings.empty()) j["warnings"] = r.warnings;
}

/// The last snapshot that can be read; those that cannot go to the faults.
std::optional<Snapshot> last_snapshot(RunFolderState& state) {
  while (!state.snapshots.empty()) {
    try {
      return read_snapshot(state.snapshots.back());
    } catch (const std::exception& error) {
      state.faults.push_back({state.snapshots.back(), error.what()});
      state.snapshots.pop_back();
      state.times.pop_back();
    }
  }
  return std::nullopt;
}

ordered_json describe_folder(const std::filesystem::path& folder) {
  RunFolderState state = state_of_run(folder);
  ordered_json j;
  j["path"] = folder.string();
  if (state.record) {
    describe_record(*state.record, state, j);
  } else {
    j["status"] = state.at_work ? "running" : "unknown";
  }
  if (std::filesystem::exists(folder / failing_state_name)) j["failing_state"] = failing_state_name;
  const std::optional<Snapshot> last = last_snapshot(state);
  j["snapshots"] = state.snapshots.size();
  if (last) {
    j["first_time"] = state.times.front();
    j["last_time"] = state.times.back();
    j["last_snapshot"] = describe_snapshot(*last);
  }
  if (state.history_rows > 0) j["history"] = {{"rows", state.history_rows}, {"last_time", state.history_end}};
  ordered_json checkpoints = ordered_json::object();
  for (const FoundCheckpoint& one : state.checkpoints) {
    if (!one.fault.empty()) {
      state.faults.push_back({one.file, one.fault});
      continue;
    }
    checkpoints[one.file.filename().string()] = {
        {"time", one.head.moment.time}, {"step", one.head.moment.step}, {"program", one.head.program}};
  }
  if (!checkpoints.empty()) j["checkpoints"] = checkpoints;
  const bool finished = state.record && state.record->status == RunStatus::finished;
  if (!finished && !state.at_work && !checkpoints.empty()) {
    j["go_on_with"] = "packstone run --resume -o " + shell_word(folder.string());
  }
  for (const FileFault& fault : state.faults) j["of_no_use"][fault.file.filename().string()] = fault.what;
  return j;
}

/// Files of packings.
ordered_json describe_series(const RunReader& series) {
  ordered_json j;
  j["path"] = series.path().string();
  j["snapshots"] = series.snapshot_count();
  if (series.snapshot_count() == 0) return j;
  j["first_time"] = series.times().front();
  j["last_time"] = series.times().back();
  j["last_snapshot"] = describe_snapshot(series.snapshot(series.snapshot_count() - 1));
  return j;
}

/// Whether a folder holds any of what a run writes.
bool is_of_a_run(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) && (holds_run(path) || !snapshot_files(path).empty());
}

void print_text(const ordered_json& object, int indent) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      fmt::print("{:{}}{}\n", "", indent, key);
      print_text(value, indent + 2);
    } else {
      fmt::print("{:{}}{:<{}} {}\n", "", indent, key, 17 - indent,
                 value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
}

void info(const InfoOptions& options) {
  if (!options.scene_reference.empty()) {
    fmt::print("{}", options.scene_reference == "markdown" ? scene_reference_markdown() : scene_reference_text());
    return;
  }
  if (options.path.empty()) throw InputError("info: name a run folder or a file");
  const ordered_json description =
      is_of_a_run(options.path) ? describe_folder(options.path) : describe_series(RunReader(options.path));
  if (options.json) {
    fmt::print("{}\n", description.dump(2));
  } else {
    print_text(description, 0);
  }
}

}  // namespace

void add_info(Program& program) {
  auto options = std::make_shared<InfoOptions>();
  Verb verb = program.add_verb("info", "Tell what a run folder or a snapshot holds");
  verb.add("path", options->path, "Run folder, snapshot, or a file of another program");
  verb.add_flag("--json", options->json, "As JSON");
  verb.add("--scene-reference", options->scene_reference, "Print the reference of the scene's keys instead")
      .one_of({"text", "markdown"});
  verb.set_action([options] { info(*options); });
}

}  // namespace packstone::cli
