#include "viz/png.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include "core/error.hpp"
#include "core/files.hpp"

namespace packstone::viz {

namespace {

constexpr std::size_t channels = 3;
constexpr std::size_t block_bytes = 1 << 18;  ///< compressed at a time; whole rows, so that bands do not matter

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view rgb_of_8_bits = {"\x08\x02\x00\x00\x00", 5};  // bits, colour, compression, filter, interlace
constexpr std::uint8_t paeth_filter = 4;

std::string big_endian(std::uint32_t number) {
  return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
          static_cast<char>(number)};
}

std::string png_chunk(std::string_view type, std::string_view data) {
  std::string bytes = big_endian(static_cast<std::uint32_t>(data.size()));
  const std::size_t summed = bytes.size();
  bytes.append(type).append(data);
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data()) + summed;
  return bytes + big_endian(crc32_gzip_refl(0, first, bytes.size() - summed));
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string text_chunk(const std::string& keyword, const std::string& text) {
  constexpr std::size_t longest_keyword = 79;
  if (keyword.empty() || keyword.size() > longest_keyword || !is_ascii(keyword)) {
    throw InputError(
        fmt::format("'{}' is no keyword of a PNG file: 1 to {} ASCII characters", keyword, longest_keyword));
  }
  const std::string end_of_keyword(1, '\0');
  if (is_ascii(text)) return png_chunk("tEXt", keyword + end_of_keyword + text);
  const std::string plain_without_language(4, '\0');  // not compressed, method, language, keyword in it
  return png_chunk("iTXt", keyword + end_of_keyword + plain_without_language + text);
}

/// All that stands before the pixels.
std::string png_head(int width, int height, const PngText& text, std::optional<double> dots_per_inch) {
  std::string head{png_signature};
  head += png_chunk("IHDR", big_endian(static_cast<std::uint32_t>(width)) +
                                big_endian(static_cast<std::uint32_t>(height)) + std::string(rgb_of_8_bits));
  if (dots_per_inch) {
    constexpr double metres_per_inch = 0.0254;
    const std::string dots_per_metre =
        big_endian(static_cast<std::uint32_t>(std::lround(*dots_per_inch / metres_per_inch)));
    head += png_chunk("pHYs", dots_per_metre + dots_per_metre + '\x01');  // 1: the unit is the metre
  }
  for (const auto& [keyword, value] : text) head += text_chunk(keyword, value);
  return head;
}

/// Every byte less the one of its left, upper and upper left neighbours that is nearest to left + upper - upper left:
/// the filter of Paeth (PNG specification, 9.4). Without branches, so that it vectorises; not inlined,
/// where GCC forgets __restrict and takes 15 times as long.
[[gnu::noinline]] void filter_row(std::uint8_t* __restrict target, const std::uint8_t* __restrict row,
                                  const std::uint8_t* __restrict above, std::size_t bytes) {
  for (std::size_t i = 0; i < channels; ++i) target[i] = static_cast<std::uint8_t>(row[i] - above[i]);
  for (std::size_t i = channels; i < bytes; ++i) {
    const std::int16_t left = row[i - channels], upper = above[i], corner = above[i - channels];
    const auto down = static_cast<std::int16_t>(upper - corner), across = static_cast<std::int16_t>(left - corner);
    const auto to_left = static_cast<std::int16_t>(std::abs(down));
    const auto to_upper = static_cast<std::int16_t>(std::abs(across));
    const auto to_corner = static_cast<std::int16_t>(std::abs(down + across));
    const std::int16_t nearest = std::min(std::min(to_left, to_upper), to_corner);
    const std::int16_t of_upper = to_upper == nearest ? upper : corner;
    target[i] = static_cast<std::uint8_t>(row[i] - (to_left == nearest ? left : of_upper));
  }
}

}  // namespace

/// The file and the deflate stream that goes into its IDAT chunks. Level 1 of ISA-L: docs/picture_files.md has the
/// choice.
struct PngWriter::File {
  /// ISA-L looks at so many bytes beyond its input, and what stands there can decide between two equal matches.
  static constexpr std::size_t look_ahead = 512;

  explicit File(const std::filesystem::path& target) : pending(target) {
    isal_deflate_init(&stream);
    stream.level = 1;
    stream.level_buf = work_space.data();
    stream.level_buf_size = static_cast<std::uint32_t>(work_space.size());
    stream.gzip_flag = IGZIP_ZLIB;
  }

  void compress(std::vector<std::uint8_t>& bytes, bool last) {
    const std::size_t count = bytes.size();
    bytes.resize(count + look_ahead, 0);
    stream.next_in = bytes.data();
    stream.avail_in = static_cast<std::uint32_t>(count);
    stream.end_of_stream = last;
    do {
      stream.next_out = packed.data();
      stream.avail_out = static_cast<std::uint32_t>(packed.size());
      isal_deflate(&stream);
      const std::size_t made = packed.size() - stream.avail_out;
      if (made > 0) pending.write(png_chunk("IDAT", {reinterpret_cast<const char*>(packed.data()), made}));
    } while (stream.avail_out == 0);
    bytes.clear();
  }

  PendingFile pending;
  isal_zstream stream{};
  std::vector<std::uint8_t> work_space = std::vector<std::uint8_t>(ISAL_DEF_LVL1_DEFAULT);
  std::vector<std::uint8_t> packed = std::vector<std::uint8_t>(block_bytes);
};

PngWriter::PngWriter(const std::filesystem::path& path, int width, int height, const PngText& text,
                     std::optional<double> dots_per_inch)
    : row_bytes_(static_cast<std::size_t>(std::max(width, 0)) * channels), rows_left_(height), above_(row_bytes_) {
  if (width < 1 || height < 1) throw InputError(fmt::format("a picture of {} x {} px has no pixels", width, height));
  const std::string head = png_head(width, height, text, dots_per_inch);
  filtered_.reserve(block_bytes + 1 + row_bytes_ + File::look_ahead);
  file_ = std::make_unique<File>(path);
  file_->pending.write(head);
}

PngWriter::~PngWriter() = default;

void PngWriter::add_rows(const std::uint8_t* rgb, int rows) {
  if (rows > rows_left_) {
    throw InputError(fmt::format("{} rows for a picture that has {} left", rows, rows_left_));
  }
  const std::uint8_t* above = above_.data();
  for (int k = 0; k < rows; ++k, above = rgb, rgb += row_bytes_) {
    const std::size_t place = filtered_.size();
    filtered_.resize(place + 1 + row_bytes_);
    filtered_[place] = paeth_filter;
    filter_row(&filtered_[place + 1], rgb, above, row_bytes_);
    if (filtered_.size() >= block_bytes) file_->compress(filtered_, false);
  }
  if (rows > 0) std::copy_n(above, row_bytes_, above_.data());
  rows_left_ -= rows;
}

void PngWriter::finish(const PngText& text) {
  if (rows_left_ > 0) throw InputError(fmt::format("{} rows of the picture are missing", rows_left_));
  file_->compress(filtered_, true);
  for (const auto& [keyword, value] : text) file_->pending.write(text_chunk(keyword, value));
  file_->pending.write(png_chunk("IEND", {}));
  file_->pending.commit();
}

void write_png(const std::filesystem::path& path, const Image& image, const PngText& text,
               std::optional<double> dots_per_inch) {
  PngWriter writer(path, image.width, image.height, text, dots_per_inch);
  writer.add_rows(image.rgb.data(), image.height);
  writer.finish();
}

Image read_png(const std::filesystem::path& path) {
  vtkNew<vtkPNGReader> reader;
  if (!std::filesystem::is_regular_file(path) || reader->CanReadFile(path.c_str()) == 0) {
    throw InputError(fmt::format("{} is not a PNG file", path.string()));
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  const int components = data->GetNumberOfScalarComponents();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || data->GetScalarType() != VTK_UNSIGNED_CHAR || components < 3) {
    throw InputError(fmt::format("{} is not an RGB picture of 8 bits", path.string()));
  }
  const int* size = data->GetDimensions();
  Image image{size[0], size[1], {}};
  image.rgb.reserve(static_cast<std::size_t>(image.width) * image.height * 3);
  for (int row = image.height - 1; row >= 0; --row) {
    const auto* source = static_cast<const std::uint8_t*>(data->GetScalarPointer(0, row, 0));
    for (int column = 0; column < image.width; ++column, source += components) {
      image.rgb.insert(image.rgb.end(), source, source + 3);
    }
  }
  return image;
}

}  // namespace packstone::viz
