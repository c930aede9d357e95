#include "core/run_folder.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/checkpoints.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/run_verdict_json.hpp"
#include "core/units.hpp"

namespace packstone {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr const char* status_names[] = {"running", "finished", "failed", "interrupted"};
constexpr const char* snapshot_extension = ".vtkhdf";
constexpr const char* series_name = "snapshots.vtkhdf.series";

bool is_run_folder(const fs::path& path) { return fs::is_regular_file(path / "run.json"); }

/// Of a folder that must be a run's.
std::vector<fs::path> snapshots_in(const fs::path& path) {
  if (!is_run_folder(path)) {
    throw InputError(
        path.string() +
        ": not a run folder (it has no run.json); of another program's files name one, or all by a pattern "
        "such as 'post/dump_*'");
  }
  return snapshot_files(path);
}

std::string snapshot_name(std::size_t number) { return fmt::format("snapshot_{:06}{}", number, snapshot_extension); }

/// In the order in which they may go: what says that a run is here, last.
constexpr const char* parts_of_a_run[] = {"snapshots",   failing_state_name, Checkpoints::folder_name,
                                          "history.csv", "scene.toml",       "run.json"};

/// A folder without run.json that holds nothing but what a run makes before that.
bool holds_beginning(const fs::path& path) {
  std::error_code error;
  bool any = false;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    const std::string name = entry.path().filename().string();
    const bool is_temporary = name.starts_with('.') && name.find(".partial") != std::string::npos;
    const bool is_empty_part =
        entry.is_directory(error) && fs::is_empty(entry.path(), error) &&
        std::find(std::begin(parts_of_a_run), std::end(parts_of_a_run), name) != std::end(parts_of_a_run);
    if (!is_temporary && !is_empty_part && name != FolderLock::name) return false;
    any = true;
  }
  return any;
}

/// Whether a time is among ascending ones, or beside them by no more than half of their mean interval.
bool is_near(const std::vector<double>& times, double time) {
  constexpr double rounding = 1e-9;  // of a time that was printed and read
  const double interval = times.size() > 1 ? (times.back() - times.front()) / static_cast<double>(times.size() - 1) : 0;
  const double margin = 0.5 * interval + rounding * std::abs(time);
  return time >= times.front() - margin && time <= times.back() + margin;
}

void write_record_into(const fs::path& folder, const RunRecord& r) {
  ordered_json json = {{"title", r.title},
                       {"version", r.version},
                       {"git_revision", r.git_revision},
                       {"compiler", r.compiler},
                       {"machine", r.machine},
                       {"scene_hash", r.scene_hash},
                       {"filling_hash", r.filling_hash},
                       {"seed", r.seed},
                       {"threads", r.threads},
                       {"status", to_string(r.status)},
                       {"reason", r.reason},
                       {"warnings", r.warnings},
                       {"particles", r.particles},
                       {"steps", r.steps},
                       {"wall_seconds", r.wall_seconds},
                       {"loop_seconds", r.loop_seconds},
                       {"list_seconds", r.list_seconds},
                       {"list_builds", r.list_builds},
                       {"processor_seconds", r.processor_seconds}};
  if (r.failure) json["failure"] = to_json(*r.failure);
  for (const RunVerdict& doubt : r.doubts) json["doubts"].push_back(to_json(doubt));
  if (r.status == RunStatus::running) {
    json["process"] = r.process;
    json["host"] = r.host;
  }
  if (!r.ending.empty()) {
    json["integrator_steps"] = r.integrator_steps;
    json["ending"] = r.ending;
  }
  write_text_file(folder / "run.json", json.dump(2) + "\n");
}

void remove_run(const fs::path& path) {
  try {
    RunRecord record = read_record(path);
    record.status = RunStatus::interrupted;
    record.reason = "another run was to take its place";
    write_record_into(path, record);  // for what a kill leaves of it from here on
  } catch (const InputError&) {
    // It says nothing as it is.
  }
  std::error_code error;
  for (const char* part : parts_of_a_run) {
    fs::remove_all(path / part, error);
    if (error) throw InputError((path / part).string() + ": cannot be replaced: " + error.message());
  }
}

/// Folder of a run to be: empty, absent, or one of an earlier run that may be replaced or gone on with.
FolderLock prepare_folder(const fs::path& path, FolderUse use) {
  std::error_code error;
  if (fs::exists(path) && !fs::is_directory(path)) throw InputError(path.string() + ": is a file; name a folder");
  const bool is_run = holds_run(path);
  if (fs::is_directory(path) && !fs::is_empty(path, error)) {
    if (!is_run) throw InputError(path.string() + ": holds other files; name an empty or a new folder");
    if (use == FolderUse::refuse && !holds_beginning(path)) {
      throw InputError(path.string() +
                       ": holds a run already; name another folder with -o, go on with it with --resume, or replace "
                       "it with --overwrite");
    }
  }
  fs::create_directories(path, error);
  if (error) throw InputError(path.string() + ": cannot be written; name a folder you may write to");
  FolderLock lock(path);
  if (is_run && use != FolderUse::go_on) remove_run(path);
  fs::remove(path / failing_state_name, error);  // a run that goes on has not failed yet
  fs::create_directories(path / "snapshots", error);
  if (error) throw InputError(path.string() + ": cannot be written; name a folder you may write to");
  for (const fs::path& folder : {path, path / "snapshots", path / Checkpoints::folder_name}) remove_leftovers(folder);
  return lock;
}

}  // namespace

const char* to_string(RunStatus status) { return status_names[static_cast<int>(status)]; }

bool holds_run(const fs::path& folder) {
  return is_run_folder(folder) || Checkpoints(folder).any() || holds_beginning(folder);
}

std::vector<fs::path> snapshot_files(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder / "snapshots")) {
    for (const auto& entry : fs::directory_iterator(folder / "snapshots")) {
      const auto name = entry.path().filename().string();
      if (name.starts_with("snapshot_") && entry.path().extension() == snapshot_extension)
        files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

RunReader::RunReader(const fs::path& path, const PackingOptions& options)
    : RunReader(std::vector<fs::path>{path}, options) {}

RunReader::RunReader(const std::vector<fs::path>& paths, const PackingOptions& options)
    : path_(paths.front()), is_folder_(paths.size() == 1 && fs::is_directory(path_)) {
  series_ = std::make_shared<const PackingSeries>(is_folder_ ? snapshots_in(path_) : paths, options);
  for (std::size_t k = 0; k < series_->size(); ++k) {
    files_.push_back(series_->file(k));
    times_.push_back(series_->time(k));
  }
}

Snapshot RunReader::snapshot(std::size_t index, const ReadOptions& options) const {
  return series_->snapshot(index, options);
}

OpenSnapshot RunReader::open(std::size_t index) const {
  if (series_->is_snapshot(index)) return OpenSnapshot(files_.at(index));
  return OpenSnapshot(series_->snapshot(index, {.region = {}, .contacts = false}));
}

std::size_t RunReader::index_at(const std::string& where) const {
  if (files_.empty()) throw InputError(path_.string() + ": holds no snapshot yet");
  const auto count = static_cast<long>(files_.size());
  if (where == "last") return files_.size() - 1;
  if (where == "first") return 0;
  if (where.starts_with("t=")) {
    const double time = parse_quantity(where.substr(2), unit::second);
    if (!is_near(times_, time)) {
      throw InputError(fmt::format("there is no snapshot near {}; {} has t={:g} to {:g} s", where, path_.string(),
                                   times_.front(), times_.back()));
    }
    const auto nearest = std::min_element(times_.begin(), times_.end(),
                                          [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
    return static_cast<std::size_t>(nearest - times_.begin());
  }
  long index = 0;
  const auto [end, error] = std::from_chars(where.data(), where.data() + where.size(), index);
  if (error != std::errc() || end != where.data() + where.size()) {
    throw InputError(fmt::format("\"{}\" names no snapshot; use last, first, a number, or t=SECONDS", where));
  }
  if (index < -count || index >= count) {
    throw InputError(
        fmt::format("snapshot {} does not exist; {} has numbers 0 to {}", index, path_.string(), count - 1));
  }
  return static_cast<std::size_t>(index < 0 ? index + count : index);
}

RunRecord RunReader::record() const { return is_folder_ ? read_record(path_) : RunRecord{}; }

RunRecord read_record(const fs::path& folder) {
  RunRecord r;
  const fs::path file = folder / "run.json";
  try {
    const auto json = ordered_json::parse(read_text_file(file));
    r.title = json.at("title");
    r.version = json.at("version");
    r.git_revision = json.at("git_revision");
    r.compiler = json.at("compiler");
    r.machine = json.at("machine");
    r.scene_hash = json.at("scene_hash");
    r.filling_hash = json.value("filling_hash", "");  // runs before filling from a file have none
    r.seed = json.at("seed");
    r.threads = json.at("threads");
    r.reason = json.at("reason");
    const auto verdict = [&](const ordered_json& written) {
      try {
        return run_verdict_from(written);
      } catch (const InputError& error) {
        throw InputError(file.string() + ": " + error.what());
      }
    };
    if (json.contains("failure")) r.failure = verdict(json.at("failure"));
    for (const auto& doubt : json.value("doubts", ordered_json::array())) r.doubts.push_back(verdict(doubt));
    r.warnings = json.at("warnings").get<std::vector<std::string>>();
    r.wall_seconds = json.at("wall_seconds");
    r.loop_seconds = json.value("loop_seconds", 0.0);  // older runs have none of the four
    r.list_seconds = json.value("list_seconds", 0.0);
    r.list_builds = json.value("list_builds", std::int64_t{0});
    r.processor_seconds = json.value("processor_seconds", 0.0);
    r.integrator_steps = json.value("integrator_steps", std::int64_t{0});  // of overdamped motion alone
    r.ending = json.value("ending", "");
    r.steps = json.at("steps");
    r.particles = json.at("particles");
    r.process = json.value("process", std::int64_t{0});
    r.host = json.value("host", "");
    const std::string status = json.at("status");
    r.status = static_cast<RunStatus>(std::find(std::begin(status_names), std::end(status_names), status) -
                                      std::begin(status_names));
    if (r.status > RunStatus::interrupted) throw InputError(file.string() + ": unknown status \"" + status + "\"");
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string() + ": damaged: " + error.what());
  }
  return r;
}

std::string RunReader::scene_text() const {
  return is_folder_ ? read_text_file(path_ / "scene.toml") : snapshot(index_at("first")).scene_text;
}

History RunReader::history() const {
  if (!is_folder_) throw InputError(path_.string() + ": a file has no history; name the run folder");
  return read_history(path_ / "history.csv");
}

RunWriter::RunWriter(const fs::path& path, FolderUse use) : path_(path), lock_(prepare_folder(path, use)) {}

void RunWriter::write_scene(const std::string& text) const { write_text_file(path_ / "scene.toml", text); }

void RunWriter::write_record(const RunRecord& record) const { write_record_into(path_, record); }

void RunWriter::write_snapshot(const Snapshot& snapshot) {
  packstone::write_snapshot(path_ / "snapshots" / snapshot_name(times_.size()), snapshot);
  times_.push_back(snapshot.time);
  write_series();
}

void RunWriter::write_failing_state(const Snapshot& snapshot) const {
  packstone::write_snapshot(path_ / failing_state_name, snapshot);
}

void RunWriter::write_series() const {
  ordered_json files = ordered_json::array();
  for (std::size_t k = 0; k < times_.size(); ++k) files.push_back({{"name", snapshot_name(k)}, {"time", times_[k]}});
  const ordered_json json = {{"file-series-version", "1.0"}, {"files", files}};
  write_text_file(path_ / "snapshots" / series_name, json.dump(1) + "\n");
}

void RunWriter::append_history(const std::vector<std::string>& columns, const std::vector<double>& row) {
  std::string text;
  if (history_size_ == 0) {
    for (const auto& column : columns) text += (text.empty() ? "" : ",") + column;
    text += '\n';
  }
  for (std::size_t k = 0; k < row.size(); ++k) text += fmt::format("{}{}", k ? "," : "", row[k]);
  text += '\n';
  append_to_file(path_ / "history.csv", text);
  history_size_ += text.size();
}

void RunWriter::archive(Archive& a) { a(times_, history_size_); }

void RunWriter::cut_history() const {
  const fs::path file = path_ / "history.csv";
  std::error_code error;
  const std::uint64_t size = fs::exists(file) ? fs::file_size(file, error) : 0;
  if (size < history_size_) {
    throw RunError(
        fmt::format("{}: has {} bytes, but the checkpoint counts {}; rows that were there are gone, so "
                    "begin anew with --overwrite",
                    file.string(), size, history_size_));
  }
  if (size > history_size_) fs::resize_file(file, history_size_, error);
  if (error) throw RunError(file.string() + ": cannot be cut back: " + error.message());
}

void RunWriter::sync() const {
  if (history_size_ > 0) sync_to_disk(path_ / "history.csv");
}

}  // namespace packstone
