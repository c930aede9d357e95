// Several packings side by side: one scale, one legend, the same bytes from any tiles.
#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "tests/viz/bare_picture.hpp"
#include "tests/viz/packings.hpp"
#include "viz/panel_painter.hpp"
#include "viz/panels.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

PictureOptions small_picture() {
  PictureOptions options;
  options.width = 601;
  options.height = 303;
  options.supersampling = 1;
  return options;
}

Snapshot ball_in(const Vec3& size) {
  Snapshot snapshot = testing::empty_box(size);
  testing::add_particle(snapshot, Vec3(size.x() / 2, size.y() / 2, 0.3), 0.3, 0);
  return snapshot;
}

}  // namespace

TEST_CASE("one panel is the picture without panels") {
  const Snapshot snapshot = testing::layered_packing(1);
  const PictureOptions options = small_picture();
  CHECK(PanelPainter(options, {"not drawn"}, 0).paint({{snapshot, {}}}).rgb == draw_particles(snapshot, options).rgb);
}

TEST_CASE("panels of boxes of different sizes show a sphere equally large") {
  const Snapshot small = ball_in(Vec3(1, 1, 1)), large = ball_in(Vec3(2, 1, 1.5));
  for (const View view : {View::front, View::top}) {
    const PictureOptions options = testing::bare_picture(view, 601, 303);
    const Image image = PanelPainter(options, {"", ""}, 0).paint({{small, {}}, {large, {}}});
    // Its pixels by their hue: no letter has any.
    int covered[2] = {0, 0};
    for (int row = 0; row < image.height; ++row) {
      for (int column = 0; column < image.width; ++column) {
        const Colour c = image.at(column, row);
        if (c.r > c.b + 20) ++covered[column < image.width / 2 ? 0 : 1];
      }
    }
    REQUIRE(covered[0] > 500);
    CHECK(covered[1] == Approx(covered[0]).epsilon(0.02));
  }
}

TEST_CASE("panels of different groups have a colour for each name") {
  Snapshot one = ball_in(Vec3::Ones()), two = one;
  one.groups = {{"heavy", "steel", 2400}};  // the second group of the other
  two.type = {1};
  const PictureOptions options = testing::bare_picture(View::iso, 601, 303);
  const Image image = PanelPainter(options, {"", ""}, 0).paint({{one, {}}, {two, {}}});
  int orange[2] = {0, 0}, blue = 0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const Colour c = image.at(column, row);
      if (c.r > c.b + 20) ++orange[column < image.width / 2 ? 0 : 1];
      if (c.b > c.r + 20) ++blue;
    }
  }
  CHECK(orange[0] > 500);
  CHECK(orange[1] == Approx(orange[0]).epsilon(0.02));
  CHECK(blue == 0);
}

TEST_CASE("tiles over panels make the whole, times that differ stand in the titles") {
  Snapshot first = testing::layered_packing(1), second = first;
  const PictureOptions options = small_picture();
  PanelPainter same(options, {"a", "b", "c", "d"}, 0), later(options, {"a", "b", "c", "d"}, 0);
  const Image whole = same.paint({{first, {}}, {second, {}}, {first, {}}, {second, {}}});
  Image merged{options.width, options.height, std::vector<std::uint8_t>(whole.rgb.size())};
  for (int left = 0; left < options.width; left += 97) {
    for (int top = 0; top < options.height; top += 71) {
      const PixelWindow tile{left, top, std::min(97, options.width - left), std::min(71, options.height - top)};
      place(merged, same.part(tile), left, top);
    }
  }
  CHECK(merged.rgb == whole.rgb);
  second.time += 1;
  CHECK(later.paint({{first, {}}, {second, {}}, {first, {}}, {second, {}}}).rgb != whole.rgb);
}

TEST_CASE("panels are counted and lettered, and need room") {
  CHECK(panel_columns(0, 1) == 1);
  CHECK(panel_columns(0, 3) == 3);
  CHECK(panel_columns(0, 4) == 2);
  CHECK(panel_columns(0, 7) == 3);
  CHECK(panel_columns(5, 2) == 2);
  CHECK(lettered(1, "wet") == "(b) wet");
  CHECK(lettered(27, "") == "(b)");
  const Snapshot snapshot = ball_in(Vec3::Ones());
  PictureOptions narrow = small_picture();
  narrow.width = 60;
  CHECK_THROWS_AS(PanelPainter(narrow, {"", "", ""}, 0).paint({{snapshot, {}}, {snapshot, {}}, {snapshot, {}}}),
                  InputError);
}
