// packstone convert: packings of any program into the format of another.

#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/like_scene.hpp"
#include "cli/progress.hpp"
#include "cli/selection.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/packing_output.hpp"
#include "core/run_folder.hpp"
#include "core/text_lines.hpp"
#include "core/version.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

struct ConvertOptions {
  std::vector<fs::path> paths;  ///< the last is what to write
  fs::path like;
  std::string at;
  std::string contact_columns;
  std::string wall_columns;
  PackingOptions packing;
  bool overwrite = false;
  bool quiet = false;
};

std::vector<std::string> column_names(const std::string& text) {
  std::vector<std::string> names;
  if (text.empty()) return names;
  for (const std::string_view name : split(text, ',')) names.emplace_back(name);
  return names;
}

std::string program_name() { return fmt::format("packstone {} (git {})", version(), git_revision()); }

/// Where the snapshots go: a run folder, or a file.
class Output {
 public:
  Output(const fs::path& path, const ConvertOptions& options, std::size_t instants) {
    if (!path.has_extension()) {
      run_.emplace(path, options.overwrite);
      record_.title = options.paths.front().string();
      record_.version = version();
      record_.git_revision = git_revision();
      record_.compiler = compiler();
      run_->write_record(record_);
      return;
    }
    if (instants > 1 && !holds_series(path)) {
      throw InputError(
          fmt::format("{}: the format holds one instant, {} are asked for; choose one with --at, or name a "
                      "folder",
                      path.string(), instants));
    }
    if (fs::exists(path) && !options.overwrite) {
      throw InputError(path.string() + ": is there already; name another file, or replace it with --overwrite");
    }
    check_writable(path);
    file_.emplace(path);
  }

  void write(const Snapshot& snapshot) {
    if (run_) {
      if (record_.scene_hash.empty()) run_->write_scene(snapshot.scene_text);
      run_->write_snapshot(snapshot);
    } else {
      file_->write(snapshot);
    }
    record_.steps = snapshot.step;
    record_.particles = static_cast<std::int64_t>(snapshot.size());
    record_.scene_hash = snapshot.scene_hash;
    record_.warnings = snapshot.notes;
  }

  void finish() {
    if (file_) return file_->finish();
    record_.status = RunStatus::finished;
    run_->write_record(record_);
  }

  /// Notes why it was not finished, where that can be written.
  void fail(const std::string& reason) {
    if (!run_) return;
    record_.status = RunStatus::failed;
    record_.reason = reason;
    try {
      run_->write_record(record_);
    } catch (const RunError&) {
      // A full disk is often the reason; its message is the one to pass on.
    }
  }

  const std::vector<std::string>& notes() const { return record_.warnings; }

 private:
  std::optional<RunWriter> run_;
  std::optional<PackingWriter> file_;
  RunRecord record_;
};

void convert(ConvertOptions options) {
  if (options.paths.size() < 2) throw InputError("convert: name what to read and, last, what to write");
  const fs::path target = options.paths.back();
  options.paths.pop_back();
  options.packing.contact_columns = column_names(options.contact_columns);
  options.packing.wall_columns = column_names(options.wall_columns);
  std::optional<LikeScene> like;
  if (!options.like.empty()) like.emplace(options.like);
  if (like && options.packing.time_step == 0) options.packing.time_step = like->time_step();
  const RunReader run(options.paths, options.packing);
  const bool series = !target.has_extension() || holds_series(target);
  const auto selected = selected_snapshots(run, !options.at.empty() ? options.at : series ? "all" : "last");
  Output output(target, options, selected.size());
  try {
    Progress progress("snapshots", options.quiet || selected.size() == 1);
    for (std::size_t k = 0; k < selected.size(); ++k) {
      Snapshot snapshot = run.snapshot(selected[k]);
      if (like) like->apply(snapshot, run.snapshot_files()[selected[k]].string());
      if (snapshot.program.empty()) snapshot.program = program_name();
      output.write(snapshot);
      progress.update(static_cast<std::int64_t>(k + 1), static_cast<std::int64_t>(selected.size()));
    }
    output.finish();
  } catch (const std::exception& error) {
    output.fail(error.what());
    throw;
  }
  if (options.quiet) return;
  for (const std::string& note : output.notes()) fmt::print("note: {}\n", note);
}

}  // namespace

void add_convert(Program& program) {
  auto options = std::make_shared<ConvertOptions>();
  Verb verb = program.add_verb("convert", "Turn packings of any program into the files of another");
  verb.add("paths", options->paths,
           fmt::format("IN... OUT. IN: a run folder, {}; several, or a pattern such as 'dump_*', are a series. "
                       "OUT: {}",
                       readable_formats, writable_formats));
  verb.add("--like", options->like,
           "Scene that gives domain, materials, groups (in the order of the types), boundaries and gravity");
  verb.add("--at", options->at, "last, first, all, a number, or t=SECONDS [all where OUT holds a series, else last]");
  verb.add("--contacts", options->packing.contacts,
           "Dump of contacts (LAMMPS, LIGGGHTS), or Yade's intrs .vtp [FILE.local beside a dump FILE]");
  verb.add("--contact-columns", options->contact_columns,
           "What the columns of the contacts are, by comma, out of id1 id2 x1 y1 z1 x2 y2 z2 fx fy fz ftx fty "
           "ftz, - for none of them");
  verb.add("--wall-contacts", options->packing.wall_contacts,
           "Dump of contacts with walls (LIGGGHTS' compute wall/gran/local) [FILE.wall beside a dump FILE]");
  verb.add("--wall-columns", options->wall_columns,
           "What its columns are, by comma, out of px py pz id x y z wall fx fy fz ftx fty ftz, - for none of them");
  verb.add("--time-step", options->packing.time_step,
           "Between steps of a file that has no times [s] [the scene's of --like]")
      .positive();
  verb.add_flag("--overwrite", options->overwrite, "Replace what is there");
  verb.add_flag("--quiet", options->quiet, "No notes and no progress");
  verb.set_action([options] { convert(*options); });
}

}  // namespace packstone::cli
