// packstone slice: the discs in which a plane cuts packings: a figure, or a film over time or over planes.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/film.hpp"
#include "cli/interrupt.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/pictures.hpp"
#include "cli/selection.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/run_folder.hpp"
#include "core/units.hpp"
#include "viz/save_drawing.hpp"
#include "viz/slice_drawing.hpp"

namespace packstone::cli {

namespace {

struct SliceCall {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path output;
  std::filesystem::path kept_frames;
  std::string frame_format = Film{}.frame_format;
  std::string plane;
  std::string sweep;
  std::string at = "last";
  std::string frames;
  int rate = 25;
  int columns = 0;
  std::vector<std::string> titles;
  int workers = 0;
  bool quiet = false;
  FigureCall figure;
  PictureCall picture;
  std::string recipe;  ///< Verb::recipe

  bool is_film() const { return !sweep.empty() || !frames.empty(); }
};

/// One picture of a film: snapshot, of each run, and plane.
struct SliceFrame {
  std::vector<std::size_t> snapshots;
  viz::SlicePlane plane;
};

viz::SliceOptions slice_options(const SliceCall& call, const std::vector<RunReader>& runs) {
  viz::SliceOptions options;
  options.supersampling = call.picture.supersampling;
  take_size(call.figure, options);
  if (!call.picture.color.empty()) options.color = call.picture.color;
  options.range = colour_range(call.picture.range);
  options.title = figure_title(runs, call.picture.title);
  options.columns = call.columns;
  return options;
}

/// The planes of "z=0:1:50", both ends among them.
std::vector<viz::SlicePlane> planes_of(const std::string& sweep) {
  const auto refuse = [&]() {
    throw InputError(
        fmt::format("--sweep {}: expected AXIS=FROM:TO:COUNT with a COUNT of 2 or more, such as "
                    "z=0:0.5:100 or \"x=10 mm:90 mm:60\"",
                    sweep));
  };
  const std::size_t first = sweep.find(':'), second = first == std::string::npos ? first : sweep.find(':', first + 1);
  if (second == std::string::npos) refuse();
  const viz::SlicePlane from = viz::plane_from_text(sweep.substr(0, first));
  int count = 0, used = 0;
  const std::string number = sweep.substr(second + 1);
  constexpr int most = 1'000'000;
  if (!from.axis || std::sscanf(number.c_str(), "%d%n", &count, &used) != 1 ||
      used != static_cast<int>(number.size()) || count < 2 || count > most) {
    refuse();
  }
  const double to = parse_quantity(sweep.substr(first + 1, second - first - 1), unit::metre);
  std::vector<viz::SlicePlane> planes;
  for (int k = 0; k < count; ++k) {
    planes.emplace_back(*from.axis, from.position + (to - from.position) * k / (count - 1));
  }
  return planes;
}

std::vector<SliceFrame> frames_of(const SliceCall& call, const std::vector<RunReader>& runs) {
  std::vector<SliceFrame> frames;
  if (call.frames.empty()) {
    std::vector<std::size_t> snapshots;
    for (const RunReader& run : runs) snapshots.push_back(run.index_at(call.at));
    const auto planes = call.sweep.empty() ? std::vector{viz::plane_from_text(call.plane)} : planes_of(call.sweep);
    for (const viz::SlicePlane& plane : planes) frames.push_back({snapshots, plane});
    return frames;
  }
  const viz::SlicePlane plane = viz::plane_from_text(call.plane);
  std::vector<std::vector<std::size_t>> indices;
  for (const RunReader& run : runs) indices.push_back(frame_range(run, call.frames));
  for (std::size_t k = 0; k < indices.front().size(); ++k) {
    SliceFrame frame{{}, plane};
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (indices[r].size() != indices.front().size()) {
        throw InputError(fmt::format("--frames {}: {} has {} such snapshots, {} has {}", call.frames,
                                     runs.front().path().string(), indices.front().size(), runs[r].path().string(),
                                     indices[r].size()));
      }
      frame.snapshots.push_back(indices[r][k]);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

/// The snapshots of a frame, kept while the next ones are of the same.
class SliceSource {
 public:
  SliceSource(const std::vector<RunReader>& runs, std::vector<std::string> titles)
      : runs_(runs), titles_(std::move(titles)) {}

  std::vector<viz::SlicePanel> panels(const SliceFrame& frame) {
    if (frame.snapshots != read_) {
      snapshots_.clear();
      for (std::size_t k = 0; k < runs_.size(); ++k) {
        snapshots_.push_back(runs_[k].open(frame.snapshots[k]));
      }
      read_ = frame.snapshots;
    }
    std::vector<viz::SlicePanel> panels;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      panels.push_back({snapshots_[k].view(), frame.plane, titles_[k]});
    }
    return panels;
  }

 private:
  const std::vector<RunReader>& runs_;
  std::vector<std::string> titles_;
  std::vector<std::size_t> read_;
  std::vector<OpenSnapshot> snapshots_;
};

/// The colour scale of a film spans all of its frames; the planes are checked before the first is drawn.
void prepare_film(viz::SliceOptions& options, SliceSource& source, const std::vector<SliceFrame>& frames) {
  const bool fix = !options.range && !viz::colours_categories(options.color);
  const std::vector<std::size_t>* read = nullptr;
  for (const SliceFrame& frame : frames) {
    if (!fix && read && frame.snapshots != frames.front().snapshots) break;  // not read for nothing
    const std::vector<viz::SlicePanel> panels = source.panels(frame);
    for (const viz::SlicePanel& panel : panels) viz::check_plane(panel.particles.snapshot->domain, panel.plane);
    if (read && *read == frame.snapshots) continue;
    read = &frame.snapshots;
    if (!fix) continue;
    for (const viz::SlicePanel& panel : panels) {
      const auto range = viz::value_range(panel.particles, options.color);
      if (range) options.range = viz::united(options.range, *range);
    }
  }
  const bool one_value = fix && options.range && !(options.range->first < options.range->second);
  if (one_value) options.range.reset();  // every picture widens it in the same way
}

void slice_film(const SliceCall& call, const std::vector<RunReader>& runs, const std::vector<SliceFrame>& frames,
                viz::Ranks& ranks) {
  viz::SliceOptions options = slice_options(call, runs);
  const std::vector<std::string> titles = panel_titles(call.titles, runs);
  SliceSource source(runs, titles);
  prepare_film(options, source, frames);
  const Provenance provenance(runs.front(), frames.front().snapshots.front(), call.recipe);
  Film film{.output = call.output,
            .kept = call.kept_frames,
            .frame_format = call.frame_format,
            .width = options.width,
            .height = options.height,
            .rate = call.rate,
            .quiet = call.quiet,
            .workers = worker_count(call.workers),
            .frames = frames.size(),
            .subject = runs.front().snapshot_files().at(frames.back().snapshots.front()).filename().string(),
            .prepare = {},
            .number = [&](std::size_t k) { return call.sweep.empty() ? frames[k].snapshots.front() : k; },
            .text = [&](std::size_t k) { return provenance.at(frames[k].snapshots.front()); },
            .dots_per_inch = dots_per_inch(call.figure)};
  film.prepare = [&] {
    const auto own = std::make_shared<SliceSource>(runs, titles);
    return [&, own](std::size_t k) {
      const viz::Drawing drawing = figure_drawing(viz::slice_drawing(own->panels(frames[k]), options), call.figure);
      Frame frame;
      if (film.needs_pixels()) frame.pixels = viz::draw_image(drawing, options.supersampling);
      if (film.has_vector_files()) {
        frame.vector_file = viz::vector_file("." + call.frame_format, drawing, options.title);
      }
      return frame;
    };
  };
  make_film(film, ranks);
}

void slice_figure(const SliceCall& call, const std::vector<RunReader>& runs, const SliceFrame& frame) {
  const viz::SliceOptions options = slice_options(call, runs);
  SliceSource source(runs, panel_titles(call.titles, runs));
  const std::size_t index = frame.snapshots.front();
  check_writable(call.output);
  save_figure(call.output, viz::slice_drawing(source.panels(frame), options), call.figure, options.supersampling,
              options.title, Provenance(runs.front(), index, call.recipe).at(index));
}

void slice(const SliceCall& call, viz::Ranks& ranks) {
  if (call.plane.empty() == call.sweep.empty()) throw InputError("a slice has --plane or --sweep, one of them");
  if (!call.sweep.empty() && !call.frames.empty()) {
    throw InputError("--sweep goes through one snapshot, --at; --frames goes through time with one --plane");
  }
  const std::string extension = call.output.extension().string();
  const bool film_name = extension == ".mp4" || extension == ".gif" || extension.empty();
  if (call.is_film() != film_name) {
    const char* const right = call.is_film() ? "a film of slices is .mp4, .gif, or a folder for its frames"
                                             : "a slice is .png, .svg or .pdf; a film takes --sweep or --frames";
    throw InputError(fmt::format("{}: {}", call.output.string(), right));
  }
  check_frame_options(call.output, call.kept_frames, call.frame_format);
  const std::vector<RunReader> runs(call.paths.begin(), call.paths.end());
  const std::vector<SliceFrame> frames = frames_of(call, runs);
  catch_interrupts();
  if (call.is_film()) {
    slice_film(call, runs, frames, ranks);
  } else if (ranks.first()) {
    slice_figure(call, runs, frames.front());
  }
}

}  // namespace

void add_slice(Program& program) {
  constexpr int most_columns = 100, most_workers = 1024;
  auto call = std::make_shared<SliceCall>();
  call->figure.size = "1600x1200";
  Verb verb = program.add_verb(slice_verb.name, slice_verb.description);
  verb.add("paths", call->paths, "Run folders, snapshots, or files of other programs; a panel for each").required();
  verb.add("-o,--output", call->output, "x.png, x.svg or x.pdf; of films x.mp4, x.gif, or a folder for frames")
      .required()
      .of_call();
  verb.add_view_options();
  verb.add("--plane", call->plane, "z=0.1, \"y=290 mm\", or any: \"through 0.1,0.1,0.2 normal 1,1,0\"");
  verb.add("--sweep", call->sweep, "A film over planes, AXIS=FROM:TO:COUNT, such as z=0:0.5:100");
  verb.add("--at", call->at, "last, first, a number, or t=SECONDS").shows_default();
  verb.add("--frames", call->frames, "A film over time: FIRST:LAST:STRIDE, : for all");
  verb.add("--keep-frames", call->kept_frames, keep_frames_description).of_call();
  verb.add("--frame-format", call->frame_format, "Of frames in a folder: png, svg or pdf")
      .one_of({"png", "svg", "pdf"})
      .shows_default()
      .of_call();
  verb.add("--rate", call->rate, "Frames a second of a film").between(1, 120).shows_default();
  verb.add("--titles", call->titles, "Of the panels, by comma [the runs']").by_comma();
  verb.add("--columns", call->columns, "Panels side by side [up to three]").between(1, most_columns);
  add_figure_options(verb, call->figure);
  add_look_options(verb, call->picture);
  verb.add("--workers", call->workers, "Processes that share the frames [one a core]")
      .between(1, most_workers)
      .of_call();
  verb.add_flag("--quiet", call->quiet, "No progress").of_call();
  verb.set_action([call, verb] {
    call->recipe = verb.recipe();
    viz::with_ranks([&](viz::Ranks& ranks) { slice(*call, ranks); });
  });
}

}  // namespace packstone::cli
