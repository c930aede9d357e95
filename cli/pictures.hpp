// Options that the picture verbs share.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "cli/command_line.hpp"
#include "core/run_folder.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/png.hpp"
#include "viz/print_size.hpp"

namespace packstone::cli {

struct PictureCall {
  std::string size = "1920x1080";
  std::string color;  ///< empty: not asked for
  std::string range;
  std::string title;
  std::string ground = "white";
  int supersampling = 2;
};

void add_picture_options(Verb& verb, PictureCall& call);
/// The same without --size.
void add_look_options(Verb& verb, PictureCall& call);

/// Width and height of "WxH" [px]. Throws InputError.
std::pair<int, int> picture_size(const std::string& text);

/// Size of a chart or a slice: in pixels or, for paper, in millimetres.
struct FigureCall {
  std::string size;
  std::string ground = "white";
  double width_mm = 0;  ///< 0: the size is in pixels
  double height_mm = 0;
  double font_pt = viz::PrintSize{}.font_pt;
  double dpi = viz::PrintSize{}.dots_per_inch;
};

void add_figure_options(Verb& verb, FigureCall& call);

/// The size on paper; nothing when it is in pixels.
std::optional<viz::PrintSize> print_size(const FigureCall& call);

/// Hands the size to the ChartOptions or SliceOptions. Throws InputError.
template <class Options>
void take_size(const FigureCall& call, Options& options) {
  const auto print = print_size(call);
  if (!print) {
    std::tie(options.width, options.height) = picture_size(call.size);
    return;
  }
  options.width = print->width();
  options.height = print->height();
  options.margin = viz::print_margin;
  options.font_scale = print->font() / viz::font_size(options.width, options.height);
  const int fitting = viz::max_drawing_side / std::max(options.width, options.height);
  options.supersampling = std::clamp(fitting, 1, options.supersampling);
}

/// Of its PNG, where the size is on paper.
std::optional<double> dots_per_inch(const FigureCall& call);

/// The drawing in the size and on the ground asked for. Throws InputError.
viz::Drawing figure_drawing(viz::Drawing drawing, const FigureCall& call);

/// The drawing as a file, in the size asked for.
void save_figure(const std::filesystem::path& path, viz::Drawing drawing, const FigureCall& call, int supersampling,
                 const std::string& title, const viz::PngText& text = {});

/// "white" or "dark". Throws InputError.
viz::Ground ground_named(const std::string& name);

/// "LOW:HIGH" in SI; nothing when empty. Throws InputError.
std::optional<std::pair<double, double>> colour_range(const std::string& text);

/// Where pictures come from and how they were made, for a PNG's text chunks.
class Provenance {
 public:
  /// index: of a snapshot that is read for the scene's hash. recipe: a view file's text.
  Provenance(const RunReader& run, std::size_t index, std::string recipe);
  /// Of a picture of a snapshot.
  viz::PngText at(std::size_t index) const;

 private:
  std::string name_, scene_hash_, recipe_;
  std::vector<double> times_;
};

/// Processes that share work where so many are asked for; 0: one a core.
int worker_count(int asked_for);

/// The given title, or that of the run; of several each panel has its own.
std::string figure_title(const std::vector<RunReader>& runs, const std::string& given);

/// What panels are called: as given, else by the run's title or the file's name. Throws InputError for another number.
std::vector<std::string> panel_titles(const std::vector<std::string>& given, const std::vector<RunReader>& runs);

}  // namespace packstone::cli
