#include "cli/pictures.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/scene.hpp"
#include "core/units.hpp"
#include "core/version.hpp"

namespace packstone::cli {

void add_picture_options(Verb& verb, PictureCall& call) {
  verb.add("--size", call.size, "Width and height in pixels").shows_default();
  verb.add("--color", call.color, "type, material, radius, speed, or a field of the snapshot").shows_default();
  verb.add("--range", call.range, "LOW:HIGH of the colour scale, SI");
  verb.add("--title", call.title, "Title [the run's]; - for none");
  verb.add("--supersampling", call.supersampling, "Every pixel is the mean of so many squared")
      .between(1, 4)
      .shows_default();
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

viz::PngText provenance(const RunReader& run, const Snapshot& snapshot) {
  return {{"Software", fmt::format("packstone {} (git {})", version(), git_revision())},
          {"Source", fmt::format("{} t={:g} s", run.path().filename().string(), snapshot.time)},
          {"Description", "scene hash " + snapshot.scene_hash}};
}

std::string picture_title(const RunReader& run, const std::string& given) {
  if (given == "-") return "";
  return given.empty() && run.is_folder() ? run.record().title : given;
}

}  // namespace packstone::cli
