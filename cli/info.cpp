// packstone info: what a run folder or a snapshot is, and the reference of the scene's keys.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/run_folder.hpp"
#include "core/run_verdict_json.hpp"
#include "core/scene.hpp"

namespace packstone::cli {

namespace {

using nlohmann::ordered_json;

struct InfoOptions {
  std::filesystem::path path;
  std::string scene_reference;
  bool json = false;
};

ordered_json describe_run(const RunReader& run) {
  ordered_json j;
  j["path"] = run.path().string();
  if (run.is_folder()) {
    const RunRecord r = run.record();
    j["title"] = r.title;
    j["status"] = to_string(r.status);
    if (!r.reason.empty()) j["reason"] = r.reason;
    if (r.failure) j["failure"] = to_json(*r.failure);
    if (std::filesystem::exists(run.path() / failing_state_name)) j["failing_state"] = failing_state_name;
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
  j["snapshots"] = run.snapshot_count();
  if (run.snapshot_count() == 0) return j;
  j["first_time"] = run.times().front();
  j["last_time"] = run.times().back();
  const Snapshot s = run.snapshot(run.snapshot_count() - 1);
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
  j["last_snapshot"] = {{"particles", s.size()},
                        {"groups", groups},
                        {"fields", fields},
                        {"contacts", s.contacts ? ordered_json(s.contacts->size()) : ordered_json(nullptr)},
                        {"domain_min", {s.domain.min[0], s.domain.min[1], s.domain.min[2]}},
                        {"domain_max", {s.domain.max[0], s.domain.max[1], s.domain.max[2]}},
                        {"periodic", s.domain.periodic}};
  if (!s.notes.empty()) j["last_snapshot"]["notes"] = s.notes;
  return j;
}

void print_text(const ordered_json& object, int indent) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      fmt::print("{:{}}{}\n", "", indent, key);
      print_text(value, indent + 2);
    } else {
      fmt::print("{:{}}{:<{}}{}\n", "", indent, key, 18 - indent,
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
  const ordered_json description = describe_run(RunReader(options.path));
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
