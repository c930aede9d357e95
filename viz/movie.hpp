// Movies, written by the ffmpeg program.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/files.hpp"
#include "viz/image.hpp"

namespace packstone::viz {

struct MovieOptions {
  int frames_per_second = 25;
};

/// Takes frames one by one. The file appears under its name only after finish(), whole.
class MovieWriter {
 public:
  /// .mp4 (H.264, plays everywhere) or .gif by the path's ending. Throws InputError for other endings, for odd sides of
  /// an .mp4 (H.264 has none) and for a frame rate below 1; RunError when ffmpeg is not there.
  MovieWriter(const std::filesystem::path& path, int width, int height, const MovieOptions& options = {});
  /// Without finish() nothing is left behind.
  ~MovieWriter();
  MovieWriter(const MovieWriter&) = delete;
  MovieWriter& operator=(const MovieWriter&) = delete;

  /// Throws InputError when the size differs, RunError with ffmpeg's words when it fails.
  void add(const Image& frame);

  /// Waits for ffmpeg and puts the file in place. Throws RunError when there was no frame or ffmpeg failed.
  /// while_waiting is called now and then, and ends it by what it throws.
  void finish(const std::function<void()>& while_waiting = {});

 private:
  class Encoder;

  std::unique_ptr<PendingFile> file_;
  int width_;
  int height_;
  int frames_ = 0;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace packstone::viz
