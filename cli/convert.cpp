// packstone convert: packings of any program into the format of another.

#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/like_scene.hpp"
#include "cli/progress.hpp"
#include "cli/selection.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
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
  Output(const fs::path& path, const ConvertOptions& options, std::size_t instants) : path_(path) {
    if (!path.has_extension()) {
      run_.emplace(path, options.overwrite);
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
  }

  void write(const Snapshot& snapshot) {
    if (run_) {
      if (count_ == 0) run_->write_scene(snapshot.scene_text);
      run_->write_snapshot(snapshot);
    } else {
      write_packing(path_, snapshot, count_ > 0);
    }
    ++count_;
    last_step_ = snapshot.step;
    particles_ = static_cast<std::int64_t>(snapshot.size());
    scene_hash_ = snapshot.scene_hash;
  }

  void finish(const std::string& source, const std::vector<std::string>& notes) const {
    if (!run_) return;
    RunRecord record;
    record.title = source;
    record.version = version();
    record.git_revision = git_revision();
    record.compiler = compiler();
    record.scene_hash = scene_hash_;
    record.status = RunStatus::finished;
    record.warnings = notes;
    record.steps = last_step_;
    record.particles = particles_;
    run_->write_record(record);
  }

 private:
  fs::path path_;
  std::optional<RunWriter> run_;
  std::size_t count_ = 0;
  std::int64_t last_step_ = 0, particles_ = 0;
  std::string scene_hash_;
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
  Progress progress("snapshots", options.quiet || selected.size() == 1);
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < selected.size(); ++k) {
    Snapshot snapshot = run.snapshot(selected[k]);
    if (like) like->apply(snapshot, run.snapshot_files()[selected[k]].string());
    if (snapshot.program.empty()) snapshot.program = program_name();
    notes = snapshot.notes;
    output.write(snapshot);
    progress.update(static_cast<std::int64_t>(k + 1), static_cast<std::int64_t>(selected.size()));
  }
  output.finish(options.paths.front().string(), notes);
  if (options.quiet) return;
  for (const std::string& note : notes) fmt::print("note: {}\n", note);
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
