#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/drawing.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/quantity.hpp"
#include "viz/save_drawing.hpp"
#include "viz/svg.hpp"

using namespace packstone;
using namespace packstone::viz;

TEST_CASE("marks are drawn where they are, within their clip") {
  constexpr Colour red = {200, 0, 0};
  Drawing drawing{40, 30, {}};
  drawing.clip(Box{0, 0, 20, 30});
  drawing.disc({20, 15}, 10, Fill{red}, std::nullopt);
  drawing.end_clip();
  drawing.rectangle({30, 0, 40, 10}, Fill{red}, std::nullopt);
  const Image image = draw_image(drawing, 2);
  CHECK(image.at(15, 15) == red);
  CHECK(image.at(25, 15) == paper);
  CHECK(image.at(35, 5) == red);
  CHECK(image.at(35, 15) == paper);
}

TEST_CASE("a layer of marks is clear where there are none and half so where they half cover") {
  Drawing drawing{4, 4, {}};
  drawing.rectangle({0, 0, 2.5, 4}, Fill{{200, 100, 0}}, std::nullopt);
  for (const int supersampling : {1, 2}) {
    const Layer layer = DrawingPainter().paint(drawing, supersampling);
    const auto pixel = [&](int column) {
      const auto first = layer.rgba.begin() + column * 4;
      return std::vector<std::uint8_t>(first, first + 4);
    };
    CHECK(pixel(1) == std::vector<std::uint8_t>{200, 100, 0, 255});
    CHECK(pixel(2)[3] == Approx(128).margin(1));
    CHECK(pixel(2)[0] == Approx(100).margin(1));  // premultiplied
    CHECK(pixel(3) == std::vector<std::uint8_t>{0, 0, 0, 0});
  }
  CHECK_THROWS_AS(DrawingPainter().paint(drawing, max_drawing_side), InputError);
  CHECK_THROWS_AS(draw_image(Drawing{}, 1), InputError);
}

TEST_CASE("a dash pattern draws its share of a line") {
  const auto pieces = dashed({{0, 0}, {7, 0}, {10, 0}}, {2, 1});
  REQUIRE(pieces.size() == 4);
  CHECK(pieces[1].front().x == Approx(3));
  CHECK(pieces[2].back().x == Approx(8));
  CHECK(dashed({{0, 0}, {7, 0}}, {}).size() == 1);
}

TEST_CASE("axes have round ticks and share their power of ten") {
  CHECK(linear_ticks(0, 1.17, 6).labels == std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  const Ticks small = linear_ticks(-2e-5, 4e-5, 3);
  CHECK(small.exponent == -5);
  CHECK(small.labels == std::vector<std::string>{"-2", "0", "2", "4"});
  CHECK(with_exponent("Energy [J]", small.exponent) == "Energy [10⁻⁵ J]");
  CHECK(logarithmic_ticks(1e-3, 1e2, 10).labels.front() == "10⁻³");
  CHECK(logarithmic_ticks(1e-3, 1e2, 10).values.size() == 6);
}

TEST_CASE("lengths and times are read in units of their size") {
  CHECK(length_text(0.586) == "0.586 m");
  CHECK(length_text(0.02) == "20 mm");
  CHECK(length_text(50e-6) == "50 µm");
  CHECK(length_text(0) == "0 m");
  CHECK(time_text(1.25) == "t = 1.250 s");
  CHECK(time_text(2.5e-3) == "t = 2.500 ms");
  CHECK(round_below(0.37) == Approx(0.2));
}

TEST_CASE("text is made safe for SVG and HTML") {
  CHECK(escaped("a<b> & \"c\"\x01") == "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST_CASE("a drawing is saved by the ending of its name") {
  testing::TemporaryFolder folder;
  Drawing drawing{20, 10, {}};
  drawing.text({2, 8}, "x", {});
  save_drawing(folder / "a.svg", drawing, 1, "a");
  save_drawing(folder / "a.png", drawing, 1, "a");
  CHECK(std::filesystem::exists(folder / "a.svg"));
  CHECK(read_png(folder / "a.png").width == 20);
  CHECK_THROWS_AS(save_drawing(folder / "a.bmp", drawing, 1, "a"), InputError);
  CHECK_THROWS_AS(save_drawing(folder / "missing/a.svg", drawing, 1, "a"), RunError);
}
