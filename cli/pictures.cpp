#include "cli/pictures.hpp"

#include <cstdio>
#include <limits>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/scene.hpp"
#include "core/units.hpp"
#include "core/version.hpp"
#include "viz/save_drawing.hpp"

namespace packstone::cli {

namespace {

void add_ground(Verb& verb, std::string& ground) { verb.add("--ground", ground, "white or dark").shows_default(); }

}  // namespace

void add_picture_options(Verb& verb, PictureCall& call) {
  add_ground(verb, call.ground);
  verb.add("--size", call.size, "Width and height in pixels").shows_default();
  add_look_options(verb, call);
}

void add_look_options(Verb& verb, PictureCall& call) {
  verb.add("--color", call.color,
           "type, material, radius, speed, a field of the snapshot, or category:FIELD for whole numbers [type, or "
           "offender where a run was stopped]");
  verb.add("--range", call.range, "LOW:HIGH of the colour scale, SI");
  verb.add("--title", call.title, "Title [the run's]; - for none");
  verb.add("--supersampling", call.supersampling, "Every pixel is the mean of so many squared")
      .between(1, 4)
      .shows_default();
}

void add_figure_options(Verb& verb, FigureCall& call) {
  add_ground(verb, call.ground);
  constexpr double narrowest = 10, widest = 1000;  // [mm]
  constexpr double smallest_font = 3, largest_font = 72;
  constexpr double coarsest = 50, finest = 2400;
  const Option size = verb.add("--size", call.size, "Width and height in pixels").shows_default();
  Option width = verb.add("--width-mm", call.width_mm, "Width on paper, for journals").between(narrowest, widest);
  Option height = verb.add("--height-mm", call.height_mm, "Height on paper").between(narrowest, widest);
  width.needs(height).not_with(size);
  height.needs(width);
  verb.add("--font-pt", call.font_pt, "Size of the letters on paper")
      .between(smallest_font, largest_font)
      .shows_default()
      .needs(width);
  verb.add("--dpi", call.dpi, "Pixels to an inch of paper, of a PNG")
      .between(coarsest, finest)
      .shows_default()
      .needs(width);
}

viz::Ground ground_named(const std::string& name) {
  if (name == "white") return viz::Ground::white;
  if (name == "dark") return viz::Ground::dark;
  throw InputError(fmt::format("--ground {}: expected white or dark", name));
}

std::optional<viz::PrintSize> print_size(const FigureCall& call) {
  if (call.width_mm == 0) return std::nullopt;
  return viz::PrintSize{call.width_mm, call.height_mm, call.font_pt, call.dpi};
}

std::optional<double> dots_per_inch(const FigureCall& call) {
  const auto print = print_size(call);
  return print ? std::optional(print->dots_per_inch) : std::nullopt;
}

viz::Drawing figure_drawing(viz::Drawing drawing, const FigureCall& call) {
  if (const auto print = print_size(call)) viz::prepare_for_print(drawing, *print);
  return viz::themed(std::move(drawing), ground_named(call.ground));
}

void save_figure(const std::filesystem::path& path, viz::Drawing drawing, const FigureCall& call, int supersampling,
                 const std::string& title, const viz::PngText& text) {
  viz::save_drawing(path, figure_drawing(std::move(drawing), call), supersampling, title, text);
}

std::pair<int, int> picture_size(const std::string& text) {
  int width = 0, height = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) != 2 || used != static_cast<int>(text.size()) ||
      width < 1 || height < 1) {
    throw InputError(fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, such as 1920x1080", text));
  }
  return {width, height};
}

std::optional<std::pair<double, double>> colour_range(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw InputError(fmt::format("--range {}: expected LOW:HIGH", text));
  return std::pair{parse_quantity(text.substr(0, colon), unit::none),
                   parse_quantity(text.substr(colon + 1), unit::none)};
}

Provenance::Provenance(const RunReader& run, std::size_t index, std::string recipe)
    : name_(run.path().filename().string()), recipe_(std::move(recipe)), times_(run.times()) {
  if (run.snapshot_files().at(index).extension() != ".vtkhdf") return;  // other programs' files have no hash
  constexpr double nowhere = std::numeric_limits<double>::max();
  const Region no_particles{Vec3::Constant(nowhere), Vec3::Constant(nowhere)};
  scene_hash_ = run.snapshot(index, {.region = no_particles, .contacts = false, .fields = false}).scene_hash;
}

viz::PngText Provenance::at(std::size_t index) const {
  return {{"Software", fmt::format("packstone {} (git {})", version(), git_revision())},
          {"Source", fmt::format("{} t={:g} s", name_, times_.at(index))},
          {"Description", "scene hash " + scene_hash_},
          {"Recipe", recipe_}};
}

int worker_count(int asked_for) {
  return asked_for > 0 ? asked_for : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::string figure_title(const std::vector<RunReader>& runs, const std::string& given) {
  if (given == "-") return "";
  if (!given.empty() || runs.size() > 1) return given;
  return runs.front().is_folder() ? runs.front().record().title : "";
}

std::vector<std::string> panel_titles(const std::vector<std::string>& given, const std::vector<RunReader>& runs) {
  if (!given.empty() && given.size() != runs.size()) {
    throw InputError(fmt::format("--titles: {} for {} panels", given.size(), runs.size()));
  }
  if (!given.empty()) return given;
  std::vector<std::string> titles;
  for (const RunReader& run : runs) {
    const std::string title = run.is_folder() ? run.record().title : "";
    titles.push_back(title.empty() ? run.path().stem().string() : title);
  }
  return titles;
}

}  // namespace packstone::cli
