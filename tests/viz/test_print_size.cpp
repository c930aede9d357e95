// Pictures for paper: what a ruler would find on the page.
#include <cstdio>

#include <catch2/catch.hpp>

#include "core/files.hpp"
#include "tests/shell.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/png.hpp"
#include "viz/print_size.hpp"
#include "viz/save_drawing.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::Contains;

namespace {

Drawing figure(const PrintSize& print) {
  Drawing drawing{print.width(), print.height(), {}};
  drawing.line({0, 0}, {9, 9}, {ink, 0.01, {}});
  drawing.rectangle({0, 0, 9, 9}, std::nullopt, Stroke{ink, 100, {}});
  drawing.disc({5, 5}, 4, Fill{ink}, Stroke{ink, 0.01, {}});
  drawing.text({100, 200}, "Hamburg", {.size = print.font()});
  prepare_for_print(drawing, print);
  return drawing;
}

}  // namespace

TEST_CASE("a print's pixels follow from millimetres, points and dots an inch") {
  const PrintSize print{85, 55, 8, 600};
  CHECK(print.width() == 2008);  // 85 / 25.4 * 600 = 2007.9
  CHECK(print.height() == 1299);
  CHECK(print.font() == Approx(66.667));  // 8 / 72 * 600
}

TEST_CASE("no line of a print is thinner than half a point, no outline of a disc than a quarter") {
  const Drawing drawing = figure({85, 55, 8, 144});  // two pixels a point
  CHECK(std::get<LineMark>(drawing.marks[0]).stroke.width == Approx(1));
  CHECK(std::get<PolygonMark>(drawing.marks[1]).outline->width == Approx(100));
  CHECK(std::get<DiscMark>(drawing.marks[2]).outline->width == Approx(0.5));
}

TEST_CASE("files for paper have their size on it") {
  const testing::TemporaryFolder folder;
  const Drawing drawing = figure({85, 55, 8, 300});
  for (const char* name : {"a.svg", "a.pdf", "a.png"}) save_drawing(folder / name, drawing, 1, "");
  CHECK_THAT(read_text_file(folder / "a.svg"), Contains("width='85mm' height='55mm' viewBox='0 0 1004 650'"));
  const std::string pdf = testing::quoted(folder / "a.pdf");
  CHECK_THAT(testing::shell("pdfinfo " + pdf).output, Contains("240.945 x 155.906 pts"));  // 85 and 55 / 25.4 * 72
  // The box around a word is as high as its font: 1.16 times 8 points in DejaVu Sans.
  const std::string boxes = testing::shell("pdftotext -bbox " + pdf + " -").output;
  double left = 0, top = 0, right = 0, bottom = 0;
  const auto word = boxes.find("<word");
  REQUIRE(word != std::string::npos);
  REQUIRE(std::sscanf(boxes.c_str() + word, "<word xMin=\"%lf\" yMin=\"%lf\" xMax=\"%lf\" yMax=\"%lf\"", &left, &top,
                      &right, &bottom) == 4);
  CHECK(right - left == Approx(text_width("Hamburg", 8)).epsilon(0.01));
  CHECK(bottom - top == Approx(8 * 1.164).epsilon(0.01));
  CHECK_THAT(read_text_file(folder / "a.png"), Contains(std::string("pHYs\0\0\x2e\x23\0\0\x2e\x23\x01", 13)));  // 11811
}
