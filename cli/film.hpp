// Frames drawn by workers, as a film or into a folder.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "viz/image.hpp"
#include "viz/png.hpp"
#include "viz/ranks.hpp"

namespace packstone::cli {

/// A frame as drawn, in the ways that its film needs.
struct Frame {
  viz::Image pixels;        ///< for a film, and for files that are PNG
  std::string vector_file;  ///< bytes, for files that are SVG or PDF
};

struct Film {
  std::filesystem::path output;      ///< .mp4, .gif, or a folder, which is made
  std::filesystem::path kept;        ///< folder for the frames of an .mp4 or .gif, too; empty: for none
  std::string frame_format = "png";  ///< of frames in a folder: png, svg or pdf
  int width = 0;                     ///< [px]
  int height = 0;                    ///< [px]
  int rate = 25;                     ///< frames a second
  bool quiet = false;
  int workers = 1;
  std::size_t frames = 0;
  std::string subject;  ///< as WorkInUnits::subject
  /// Called once in every worker; what it returns draws a frame.
  std::function<std::function<Frame(std::size_t frame)>()> prepare;
  std::function<std::size_t(std::size_t frame)> number;  ///< in the name of its file
  std::function<viz::PngText(std::size_t frame)> text;   ///< of its PNG, without what drew it
  std::optional<double> dots_per_inch;                   ///< of its PNG

  bool is_movie() const { return output.has_extension(); }
  bool has_vector_files() const { return frame_format != "png"; }
  bool needs_pixels() const { return is_movie() || !has_vector_files(); }
};

inline constexpr const char* keep_frames_description = "Folder for the frames of an .mp4 or .gif, too";

/// Throws InputError where frames are kept of what is no film, or have a format and no folder.
void check_frame_options(const std::filesystem::path& output, const std::filesystem::path& kept,
                         const std::string& frame_format);

/// Draws all frames. In a folder those done stay when it is stopped, whole; a film is there only when it is whole.
/// Throws InputError and RunError as its files do.
void make_film(const Film& film, viz::Ranks& ranks);

}  // namespace packstone::cli
