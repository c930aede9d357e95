// Options that the picture verbs share.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "cli/command_line.hpp"
#include "core/run_folder.hpp"
#include "viz/png.hpp"

namespace packstone::cli {

struct PictureCall {
  std::string size = "1920x1080";
  std::string color = "type";
  std::string range;
  std::string title;
  int supersampling = 2;
};

void add_picture_options(Verb& verb, PictureCall& call);

/// Width and height of "WxH" [px]. Throws InputError.
std::pair<int, int> picture_size(const std::string& text);

/// "LOW:HIGH" in SI; nothing when empty. Throws InputError.
std::optional<std::pair<double, double>> colour_range(const std::string& text);

/// Where a picture comes from, for the PNG's text chunks.
viz::PngText provenance(const RunReader& run, const Snapshot& snapshot);

/// The given title, or the run's own.
std::string picture_title(const RunReader& run, const std::string& given);

}  // namespace packstone::cli
