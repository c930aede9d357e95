// Frames drawn by workers, as a film or into a folder.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "viz/image.hpp"
#include "viz/png.hpp"
#include "viz/ranks.hpp"

namespace packstone::cli {

struct Film {
  std::filesystem::path output;  ///< .mp4, .gif, or a folder, which is made
  int width = 0;                 ///< [px]
  int height = 0;                ///< [px]
  int rate = 25;                 ///< frames a second
  bool quiet = false;
  int workers = 1;
  std::size_t frames = 0;
  std::string subject;  ///< as WorkInUnits::subject
  /// Called once in every worker; what it returns draws a frame.
  std::function<std::function<viz::Image(std::size_t frame)>()> prepare;
  std::function<std::string(std::size_t frame)> file_name;  ///< in a folder
  std::function<viz::PngText(std::size_t frame)> text;      ///< of its PNG, without what drew it
};

/// Draws all frames. In a folder those done stay when it is stopped; a film is there only when it is whole.
void make_film(const Film& film, viz::Ranks& ranks);

}  // namespace packstone::cli
