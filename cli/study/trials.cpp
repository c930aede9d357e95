#include "cli/study/trials.hpp"

#include <cctype>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "analysis/measures.hpp"
#include "core/error.hpp"
#include "core/run_folder.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "engine/run.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string> short_names = {{"packing_fraction", "packing.bulk_fraction"},
                                                        {"coordination", "structure.coordination_mean"},
                                                        {"bed_height", "packing.bed_height"},
                                                        {"lacey", "segregation.lacey"}};

std::string measure_of(const std::string& quantity) { return quantity.substr(0, quantity.find('.')); }

/// The record of an earlier run by this build that came to an end.
std::optional<RunRecord> earlier(const fs::path& folder) {
  if (!fs::exists(folder / "run.json")) return std::nullopt;
  const RunReader run(folder);
  const RunRecord record = run.record();
  const bool ended = record.status == RunStatus::finished || record.status == RunStatus::failed;
  const bool same = record.version == version() && record.git_revision == git_revision();
  return ended && same ? std::optional(record) : std::nullopt;
}

RunRecord run_anew(const Scene& scene, const fs::path& folder, const TrialCall& call) {
  engine::RunControl control;
  control.threads = call.threads;
  control.overwrite = true;
  control.should_stop = call.should_stop;
  control.checkpoints = false;  // a trial that was stopped is made anew
  try {
    return engine::run_scene(scene, folder, control);
  } catch (const Interrupted&) {
    throw;
  } catch (const RunError&) {
    return RunReader(folder).record();
  }
}

void measure(const fs::path& folder, const TrialCall& call, Trial& trial) {
  std::set<std::string> names;
  for (const std::string& quantity : call.quantities) names.insert(measure_of(quantity));
  const RunReader run(folder);
  const auto results = analysis::analyze(run.snapshot(run.snapshot_count() - 1), {names.begin(), names.end()});
  for (const std::string& wanted : call.quantities) {
    for (const analysis::MeasureResult& result : results) {
      if (result.name != measure_of(wanted)) continue;
      const analysis::Quantity* quantity = result.quantity(wanted.substr(result.name.size() + 1));
      if (!quantity) {
        std::vector<std::string> known;
        for (const auto& q : result.quantities) known.push_back(result.name + "." + q.key);
        throw InputError(fmt::format("no quantity \"{}\"; there are: {}", wanted, joined(known)));
      }
      if (quantity->value) trial.values[wanted] = *quantity->value;
      trial.units[wanted] = quantity->unit;
    }
  }
}

}  // namespace

std::string file_name_of(const std::string& label) {
  std::string name = label;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
  }
  return name;
}

std::string quantity_of(const std::string& name) {
  const auto found = short_names.find(name);
  const std::string full = found == short_names.end() ? name : found->second;
  const auto dot = full.find('.');
  if (dot == std::string::npos) {
    std::vector<std::string> known;
    for (const auto& [word, quantity] : short_names) known.push_back(word);
    const auto near = nearest_name(name, known);
    throw InputError(fmt::format("\"{}\" is no quantity; {}MEASURE.QUANTITY as in analyze --json, or one of {}", name,
                                 near ? "did you mean \"" + *near + "\"? There are " : "there are ", joined(known)));
  }
  analysis::selected_measures({full.substr(0, dot)});
  return full;
}

Trial run_trial(const Scene& scene, const std::string& label, const fs::path& below, const TrialCall& call) {
  const fs::path folder = below / (file_name_of(label) + "_" + scene_hash(scene));
  const auto before = earlier(folder);
  const RunRecord record = before ? *before : run_anew(scene, folder, call);
  Trial trial;
  trial.finished = record.status == RunStatus::finished;
  trial.reason = record.reason;
  trial.seconds = record.processor_seconds;
  trial.particle_steps = static_cast<double>(record.particles) * static_cast<double>(record.steps);
  if (trial.finished) measure(folder, call, trial);
  return trial;
}

}  // namespace packstone::cli
