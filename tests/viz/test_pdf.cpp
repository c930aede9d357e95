// PDF files as poppler's programs see them, which share no code with what writes them.
#include <filesystem>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/files.hpp"
#include "tests/shell.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/png.hpp"
#include "viz/save_drawing.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

constexpr double disc_opacity = 0.4;

/// All kinds of marks.
Drawing sheet(double opacity) {
  Drawing drawing{200, 150, {}};
  const Stroke line{ink, 2, {}};
  drawing.rectangle({20, 10, 180, 110}, Fill{plate_fill}, line);
  drawing.clip(Box{20, 10, 100, 110});
  drawing.disc({100, 60}, 40, Fill{category_colour(1), opacity}, line);
  drawing.end_clip();
  drawing.band({{110, 40}, {140, 30}, {170, 50}}, {{110, 60}, {140, 70}, {170, 60}}, Fill{category_colour(0), opacity});
  drawing.polyline({{110, 90}, {140, 80}, {170, 95}}, {line_colour(0), 3, {8, 4}});
  drawing.text({100, 130}, "Energy [10⁻⁵ J]", {.size = 14, .across = Side::middle});
  drawing.text({14, 60}, "height", {.size = 12, .across = Side::middle, .upward = true});
  return drawing;
}

std::string poppler_says(const std::string& command) {
  const auto result = testing::shell(command);
  INFO(command << "\n" << result.output);
  REQUIRE(result.exit_code == 0);
  return result.output;
}

/// The first page, a pixel a point.
Image page_image(const fs::path& pdf) {
  const fs::path stem = pdf.parent_path() / "page";
  poppler_says("pdftoppm -singlefile -png -r 72 " + testing::quoted(pdf) + " " + testing::quoted(stem));
  return read_png(stem.string() + ".png");
}

}  // namespace

TEST_CASE("a PDF page has the drawing's size, its words and its font") {
  const testing::TemporaryFolder folder;
  save_drawing(folder / "a.pdf", sheet(disc_opacity), 1, "A title");
  const std::string info = poppler_says("pdfinfo " + testing::quoted(folder / "a.pdf"));
  CHECK_THAT(info, Contains("200 x 150 pts") && Contains("A title") && Contains("Pages:           1"));
  const std::string words = poppler_says("pdftotext " + testing::quoted(folder / "a.pdf") + " -");
  CHECK_THAT(words, Contains("Energy [10⁻⁵ J]") && Contains("height"));
  const std::string font = poppler_says("pdffonts " + testing::quoted(folder / "a.pdf") + " | tail -n +3");
  CHECK_THAT(font, Contains("+DejaVuSans ") && Contains(" yes yes yes "));  // embedded, in part, with Unicode
}

TEST_CASE("a PDF shows what the PNG shows") {
  const testing::TemporaryFolder folder;
  constexpr double alike = 0.8;  // measured: 0.4, of edges and letters
  const Image drawn = draw_image(sheet(disc_opacity), 3);
  save_drawing(folder / "a.pdf", sheet(disc_opacity), 1, "");
  CHECK(difference(drawn, page_image(folder / "a.pdf")) < alike);
  // What must not pass: another opacity, no clipping.
  save_drawing(folder / "b.pdf", sheet(1), 1, "");
  CHECK(difference(drawn, page_image(folder / "b.pdf")) > 2 * alike);
  Drawing unclipped = sheet(disc_opacity);
  std::erase_if(unclipped.marks, [](const Mark& mark) { return std::holds_alternative<ClipMark>(mark); });
  save_drawing(folder / "c.pdf", unclipped, 1, "");
  CHECK(difference(drawn, page_image(folder / "c.pdf")) > 2 * alike);
}

TEST_CASE("the same drawing gives the same PDF, and a circle costs few bytes") {
  const testing::TemporaryFolder folder;
  Drawing discs{200, 150, {}};
  constexpr int count = 1000;
  for (int i = 0; i < count; ++i) discs.disc({0.2 * i, 0.1 * i}, 50, Fill{ink}, std::nullopt);
  save_drawing(folder / "a.pdf", discs, 1, "");
  save_drawing(folder / "b.pdf", discs, 1, "");
  CHECK((read_text_file(folder / "a.pdf") == read_text_file(folder / "b.pdf")));
  constexpr int bytes_of_four_curves = 100;  // a polygon as fine would have hundreds of corners
  CHECK(fs::file_size(folder / "a.pdf") < count * bytes_of_four_curves);
  CHECK_THROWS_AS(save_drawing(folder / "missing/a.pdf", discs, 1, ""), RunError);
}
