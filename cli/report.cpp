// packstone report: tables, charts and pictures of runs in one page.

#include "viz/report.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <stdlib.h>

#include "analysis/measures.hpp"
#include "analysis/writers.hpp"
#include "cli/charts.hpp"
#include "cli/comparison.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/report_findings.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "core/scene.hpp"
#include "viz/particle_scene.hpp"
#include "viz/save_drawing.hpp"
#include "viz/slice_drawing.hpp"

namespace packstone::cli {

namespace {

namespace fs = std::filesystem;

constexpr int picture_side = 1000;  ///< of pictures in the page [px]
constexpr std::size_t most_table_rows = 60;
constexpr double filling_rounding = 1e-9;  ///< of the filling's duration, for times that are multiples of a step

struct ReportOptions {
  std::vector<fs::path> paths;
  fs::path output;
};

/// Pictures on their way into the page.
class PictureFolder {
 public:
  PictureFolder() {
    std::string name = (fs::temp_directory_path() / "packstone-report-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw RunError("no temporary folder can be made in " + fs::temp_directory_path().string());
    path_ = name;
  }
  ~PictureFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;

  fs::path next() { return path_ / fmt::format("{}.png", ++count_); }

 private:
  fs::path path_;
  int count_ = 0;
};

/// The first snapshot after the filling, or the last one of a run that did not get so far.
std::size_t filled_snapshot(const RunReader& run, double filling_duration) {
  std::size_t index = 0;
  while (index + 1 < run.snapshot_count() && run.times()[index] < filling_duration * (1 - filling_rounding)) ++index;
  return index;
}

ReportedMeasures measure(const RunReader& run) {
  const Scene scene = parse_scene(run.scene_text(), (run.path() / "scene.toml").string());
  ReportedMeasures m;
  const Snapshot filled = run.snapshot(filled_snapshot(run, scene.filling.over()));
  const Snapshot end = run.snapshot(run.index_at("last"));
  m.filled_time = filled.time;
  m.filling_over = filled.time >= scene.filling.over() * (1 - filling_rounding);
  m.filled = analysis::analyze(filled);
  m.end_time = end.time;
  m.end = analysis::analyze(end);
  return m;
}

/// Whether the layers' composition exists: it takes two types.
bool has_composition(const ReportedMeasures& m) {
  return std::any_of(m.end.begin(), m.end.end(), [](const auto& result) {
    return result.name == "segregation" && result.table("composition") != nullptr;
  });
}

viz::ReportSection about(const RunReader& run) {
  const RunRecord r = run.record();
  viz::ReportSection section{"The run", {}, {}, {}, run.scene_text()};
  section.tables.push_back(
      {"",
       {"", ""},
       {{"status", std::string(to_string(r.status)) + (r.reason.empty() ? "" : ": " + r.reason)},
        {"particles", fmt::format("{}", r.particles)},
        {"steps", fmt::format("{} in {:.1f} s on {} threads", r.steps, r.wall_seconds, r.threads)},
        {"seed", fmt::format("{}", r.seed)},
        {"scene hash", r.scene_hash},
        {"program", fmt::format("packstone {} (git {}), {}", r.version, r.git_revision, r.compiler)},
        {"machine", r.machine}}});
  for (const auto& warning : r.warnings) section.paragraphs.push_back("Warning: " + warning);
  section.paragraphs.push_back("The scene as run, every default filled in:");
  return section;
}

viz::ReportImage space_picture(const RunReader& run, const std::string& at, viz::View view, const std::string& caption,
                               PictureFolder& folder) {
  viz::PictureOptions options;
  options.width = options.height = picture_side;
  options.view = view;
  const fs::path file = folder.next();
  viz::write_png(file, viz::draw_particles(run.snapshot(run.index_at(at)), options));
  return {file, caption};
}

viz::ReportImage slice_picture(const RunReader& run, PictureFolder& folder) {
  const Snapshot last = run.snapshot(run.index_at("last"));
  const double middle = 0.5 * (last.domain.min.y() + last.domain.max.y());
  viz::SliceOptions options;
  options.width = options.height = picture_side;
  const fs::path file = folder.next();
  viz::write_png(file, viz::draw_slice(last, {1, middle}, options));
  return {file, fmt::format("Vertical cut at y = {:.3g} m at the end: the discs in which the plane cuts the spheres.",
                            middle)};
}

viz::ReportSection pictures(const RunReader& run, const ReportedMeasures& m, PictureFolder& folder) {
  viz::ReportSection section{"Pictures", {}, {}, {}, ""};
  section.images = {
      space_picture(run, fmt::format("t={}", m.filled_time), viz::View::iso,
                    fmt::format("{} the filling, t = {:g} s.", m.filling_over ? "After" : "During", m.filled_time),
                    folder),
      space_picture(run, "last", viz::View::iso, fmt::format("At the end, t = {:g} s.", m.end_time), folder),
      space_picture(run, "last", viz::View::top, "The surface from above, at the end.", folder),
      space_picture(run, "last", viz::View::bottom, "The bottom from below, at the end.", folder),
      slice_picture(run, folder)};
  return section;
}

viz::ReportSection charts(const std::vector<RunReader>& runs, bool with_composition, PictureFolder& folder) {
  viz::ReportSection section{"Charts", {}, {}, {}, ""};
  for (const char* name : {"energy", "account", "packing", "coordination", "composition", "profile"}) {
    if (name == std::string("composition") && !with_composition) continue;
    viz::Chart chart = make_chart(name, runs);
    chart.options.width = picture_side;
    chart.options.height = picture_side * 3 / 4;
    const fs::path file = folder.next();
    viz::save_drawing(file, viz::chart_drawing(chart), chart.options.supersampling, chart.options.title);
    section.images.push_back({file, chart.options.title});
  }
  return section;
}

viz::ReportSection measures(const ReportedMeasures& m) {
  viz::ReportSection section{"Measures", {}, {}, {}, ""};
  const std::string filled = fmt::format("t = {:g} s", m.filled_time), end = fmt::format("t = {:g} s", m.end_time);
  for (std::size_t k = 0; k < m.end.size(); ++k) {
    viz::ReportTable table{m.end[k].name, {"quantity", filled, end, "unit", "definition"}, {}};
    for (std::size_t q = 0; q < m.end[k].quantities.size(); ++q) {
      const auto& last = m.end[k].quantities[q];
      table.rows.push_back({last.label, analysis::value_text(m.filled[k].quantities[q]), analysis::value_text(last),
                            last.unit, last.definition + (last.note.empty() ? "" : " (" + last.note + ")")});
    }
    section.tables.push_back(table);
  }
  return section;
}

viz::ReportSection tables(const ReportedMeasures& m) {
  viz::ReportSection section{"Tables at the end", {}, {}, {}, ""};
  for (const auto& result : m.end) {
    for (const auto& table : result.tables) {
      viz::ReportTable shown{fmt::format("{}: {}", result.name, table.caption), {}, {}};
      for (const auto& column : table.columns) shown.columns.push_back(analysis::column_title(column));
      for (std::size_t r = 0; r < std::min(table.rows.size(), most_table_rows); ++r) {
        std::vector<std::string> cells;
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
          cells.push_back(analysis::cell_text(table.rows[r][c], table.columns[c].format));
        }
        shown.rows.push_back(cells);
      }
      if (table.rows.size() > most_table_rows) {
        shown.caption +=
            fmt::format(" (first {} of {} rows; packstone analyze --csv has all)", most_table_rows, table.rows.size());
      }
      section.tables.push_back(shown);
    }
  }
  return section;
}

viz::Report report_of_one(const RunReader& run, PictureFolder& folder) {
  const RunRecord record = run.record();
  const ReportedMeasures m = measure(run);
  viz::Report report{
      record.title,
      fmt::format("packstone {}, scene hash {}, {}", record.version, record.scene_hash, to_string(record.status)),
      {}};
  report.sections.push_back({"What the run shows", findings(run, m), {}, {}, ""});
  report.sections.push_back(pictures(run, m, folder));
  report.sections.push_back(charts({run}, has_composition(m), folder));
  report.sections.push_back(measures(m));
  report.sections.push_back(tables(m));
  report.sections.push_back(about(run));
  return report;
}

viz::ReportSection pictures_of_packing(const RunReader& run, PictureFolder& folder) {
  viz::ReportSection section{"Pictures", {}, {}, {}, ""};
  section.images = {space_picture(run, "last", viz::View::iso, "The packing.", folder),
                    space_picture(run, "last", viz::View::top, "The surface from above.", folder),
                    space_picture(run, "last", viz::View::bottom, "The bottom from below.", folder),
                    slice_picture(run, folder)};
  return section;
}

/// Of files, snapshots alone and converted runs: first and last instant, without findings and charts over time.
viz::Report report_of_packing(const RunReader& run, PictureFolder& folder) {
  const Snapshot first = run.snapshot(run.index_at("first")), last = run.snapshot(run.index_at("last"));
  ReportedMeasures m;
  m.filled_time = first.time;
  m.filled = analysis::analyze(first);
  m.end_time = last.time;
  m.end = analysis::analyze(last);
  viz::Report report{run.path().filename().string(), fmt::format("{} particles", last.size()), {}};
  viz::ReportSection origin{"The packing", last.notes, {}, {}, ""};
  origin.paragraphs.insert(origin.paragraphs.begin(),
                           fmt::format("{} of {} instants are shown: the first and the last.",
                                       std::min<std::size_t>(2, run.snapshot_count()), run.snapshot_count()));
  report.sections = {origin, pictures_of_packing(run, folder), measures(m), tables(m)};
  return report;
}

viz::Report report_of_several(const std::vector<RunReader>& runs, PictureFolder& folder) {
  viz::Report report{"Comparison of " + fmt::format("{} runs", runs.size()), "", {}};
  std::vector<std::string> labels;
  std::vector<std::vector<analysis::MeasureResult>> results;
  bool composed = true;
  for (const auto& run : runs) {
    const ReportedMeasures m = measure(run);
    composed = composed && has_composition(m);
    labels.push_back(run_label(run));
    results.push_back(m.end);
    report.sections.push_back({"What " + run_label(run) + " shows", findings(run, m), {}, {}, ""});
  }
  const Comparison comparison = compare(labels, results);
  report.sections.push_back({"Side by side, at the end", {}, {{"", comparison.columns, comparison.rows}}, {}, ""});
  report.sections.push_back(charts(runs, composed, folder));
  for (const auto& run : runs) {
    report.sections.push_back(about(run));
    report.sections.back().title += " " + run_label(run);
  }
  return report;
}

/// Files have none, and neither have runs that convert made of them.
bool has_history(const RunReader& run) { return run.is_folder() && fs::exists(run.path() / "history.csv"); }

void report(const ReportOptions& options) {
  std::vector<RunReader> runs;
  for (const auto& path : options.paths) {
    runs.emplace_back(path);
    runs.back().index_at("last");
    if (!has_history(runs.back()) && options.paths.size() > 1) {
      throw InputError(path.string() +
                       ": has no history to compare over time; report it alone, or compare numbers with analyze");
    }
  }
  if (options.output.extension() != ".html")
    throw InputError(options.output.string() + ": a report is written as .html");
  check_writable(options.output);
  PictureFolder folder;
  const auto one = [&] {
    return has_history(runs.front()) ? report_of_one(runs.front(), folder) : report_of_packing(runs.front(), folder);
  };
  viz::write_report(options.output, runs.size() == 1 ? one() : report_of_several(runs, folder));
}

}  // namespace

void add_report(Program& program) {
  auto options = std::make_shared<ReportOptions>();
  Verb verb = program.add_verb(report_verb.name, report_verb.description);
  verb.add("paths", options->paths, "Run folders, or a file of a packing").required();
  verb.add("-o,--output", options->output, "x.html").required();
  verb.set_action([options] { report(*options); });
}

}  // namespace packstone::cli
