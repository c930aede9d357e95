// PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viz/image.hpp"

namespace packstone::viz {

/// Text chunks of a PNG file: keyword ("Title", "Software", "Description", ...) and text in UTF-8.
using PngText = std::vector<std::pair<std::string, std::string>>;

/// Writes a picture of 8-bit RGB in bands of rows that arrive top to bottom, so that it need not fit in memory. The
/// bytes do not depend on the bands. The file appears under its name only after finish(), whole.
class PngWriter {
 public:
  /// The dots per inch are for programs that place the picture on a page. Throws InputError when there are no pixels or
  /// a keyword is not of 1 to 79 ASCII characters, RunError when the file cannot be written.
  PngWriter(const std::filesystem::path& path, int width, int height, const PngText& text = {},
            std::optional<double> dots_per_inch = std::nullopt);
  /// Without finish() nothing is left behind.
  ~PngWriter();
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  /// rgb is (rows * width * 3). Throws InputError when the picture has fewer rows left, RunError when the disk refuses.
  void add_rows(const std::uint8_t* rgb, int rows);

  /// Puts the file in place, with text that is known only now behind its pixels. Throws InputError when rows are
  /// missing, RunError when the disk refuses.
  void finish(const PngText& text = {});

 private:
  struct File;

  std::size_t row_bytes_;
  int rows_left_;
  std::vector<std::uint8_t> above_;     ///< the last row seen, black before the first
  std::vector<std::uint8_t> filtered_;  ///< rows not yet compressed
  std::unique_ptr<File> file_;
};

/// Writes a whole picture. Throws RunError when the disk refuses.
void write_png(const std::filesystem::path& path, const Image& image, const PngText& text = {},
               std::optional<double> dots_per_inch = std::nullopt);

/// Throws InputError when the file is not an RGB or RGBA picture of 8 bits; alpha is dropped.
Image read_png(const std::filesystem::path& path);

}  // namespace packstone::viz
