// PNG files as VTK reads them and as a reader made from the specification alone does (read_png.py).
#include <filesystem>
#include <fstream>
#include <random>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "tests/shell.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/png.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      for (const int value : {row * 7, column * 5, row + column}) image.rgb.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return image;
}

/// What no compression makes smaller.
Image noise(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  std::mt19937 random(1);
  for (std::uint8_t& value : image.rgb) value = static_cast<std::uint8_t>(random());
  return image;
}

struct Reading {
  std::string said;
  std::string pixels;
};

Reading read_by_specification(const fs::path& path) {
  const fs::path pixels = path.string() + ".rgb";
  const auto result =
      testing::shell(std::string(PACKSTONE_PYTHON) + " " PACKSTONE_SOURCE_DIR "/tests/viz/read_png.py " +
                     testing::quoted(path) + " " + testing::quoted(pixels));
  INFO(result.output);
  REQUIRE(result.exit_code == 0);
  return {result.output, read_text_file(pixels)};
}

std::string bytes_of(const Image& image) { return {image.rgb.begin(), image.rgb.end()}; }

}  // namespace

TEST_CASE("a PNG file gives back the same pixels to both readers") {
  const testing::TemporaryFolder folder;
  const auto image = GENERATE(gradient(1, 1), gradient(31, 17), gradient(1, 300), gradient(300, 1), noise(317, 311),
                              noise(21845, 4));  // the last fills its only block to the byte
  INFO(image.width << " x " << image.height);
  write_png(folder / "a.png", image);
  const Image back = read_png(folder / "a.png");
  CHECK(back.width == image.width);
  CHECK(back.height == image.height);
  CHECK((back.rgb == image.rgb));
  CHECK((read_by_specification(folder / "a.png").pixels == bytes_of(image)));
}

TEST_CASE("the bytes of a PNG file do not depend on the bands it came in") {
  const testing::TemporaryFolder folder;
  const Image image = noise(401, 700);
  write_png(folder / "whole.png", image, {{"Title", "bands"}});
  for (const int height : {1, 7, 233}) {
    PngWriter writer(folder / "bands.png", image.width, image.height, {{"Title", "bands"}});
    for (int row = 0; row < image.height; row += height) {
      writer.add_rows(&image.rgb[static_cast<std::size_t>(row) * image.width * 3],
                      std::min(height, image.height - row));
    }
    writer.finish();
    CHECK((read_text_file(folder / "bands.png") == read_text_file(folder / "whole.png")));
  }
}

TEST_CASE("a PNG file says what it is told to, in UTF-8 where ASCII does not do") {
  const testing::TemporaryFolder folder;
  write_png(folder / "a.png", gradient(3, 2), {{"Software", "packstone test"}, {"Title", "Größe 50 µm, 粉"}}, 600);
  CHECK(read_by_specification(folder / "a.png").said ==
        "size 3 2\npHYs 23622 23622 1\ntEXt Software=packstone test\niTXt Title=Größe 50 µm, 粉\n");
  CHECK_THROWS_AS(write_png(folder / "b.png", gradient(3, 2), {{"", "x"}}), InputError);
  CHECK_THROWS_AS(write_png(folder / "b.png", gradient(3, 2), {{std::string(80, 'k'), "x"}}), InputError);
  CHECK_FALSE(fs::exists(folder / "b.png"));
}

TEST_CASE("a PNG file is whole or absent") {
  const testing::TemporaryFolder folder;
  const Image image = gradient(40, 30);
  {
    PngWriter writer(folder / "a.png", image.width, image.height);
    writer.add_rows(image.rgb.data(), 20);
    CHECK_THROWS_AS(writer.add_rows(image.rgb.data(), 11), InputError);
    CHECK_THROWS_AS(writer.finish(), InputError);
  }
  CHECK(fs::is_empty(folder.path()));
  CHECK_THROWS_AS(write_png(folder / "missing/a.png", image), RunError);
  CHECK_THROWS_AS(PngWriter(folder / "a.png", 0, 3), InputError);
  fs::create_directory(folder / "taken.png");
  CHECK_THROWS_AS(write_png(folder / "taken.png", image), RunError);
  fs::remove(folder / "taken.png");
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a full disk is an error that names the file, and leaves none") {
  const testing::TemporaryFolder folder;
  for (const Image& image : {gradient(4, 4), noise(600, 600)}) {
    fs::create_symlink("/dev/full", temporary_name(folder / "a.png"));  // where every write fails for want of room
    CHECK_THROWS_WITH(write_png(folder / "a.png", image), Contains("a.png: cannot be written: No space left"));
    CHECK(fs::is_empty(folder.path()));
  }
}

TEST_CASE("what is no PNG file is not read as one") {
  const testing::TemporaryFolder folder;
  std::ofstream(folder / "text.png") << "no picture";
  CHECK_THROWS_AS(read_png(folder / "text.png"), InputError);
  CHECK_THROWS_AS(read_png(folder / "missing.png"), InputError);
}
