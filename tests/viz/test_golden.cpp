// Pictures against stored ones. After a wanted change, look at the new pictures and store them with
//   PACKSTONE_UPDATE_GOLDEN=1 build/test_viz '[golden]'
// Each has a twin with a small fault that must exceed the threshold, so that a threshold too wide fails by itself.

#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "tests/viz/packings.hpp"
#include "viz/chart.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/particle_scene.hpp"
#include "viz/png.hpp"
#include "viz/slice_drawing.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

/// Greatest difference() that still counts as the same picture: room for another version of Mesa or of the font's
/// renderer, whose edges differ.
constexpr double threshold = 0.25;

Image golden(const std::string& name, const Image& drawn) {
  const auto path = std::filesystem::path(PACKSTONE_SOURCE_DIR) / "tests" / "golden" / (name + ".png");
  if (std::getenv("PACKSTONE_UPDATE_GOLDEN") != nullptr) write_png(path, drawn);
  return read_png(path);
}

PictureOptions layers_picture() {
  PictureOptions options;
  options.width = 320;
  options.height = 240;
  options.title = "Layers";
  return options;
}

SliceOptions small_slice() {
  SliceOptions options;
  options.width = 320;
  options.height = 240;
  options.color = "speed";
  return options;
}

Chart small_chart() {
  Chart chart;
  chart.options.x_label = "Time [s]";
  chart.options.y_label = "Energy [J]";
  chart.options.width = 320;
  chart.options.height = 240;
  chart.series = {{"kinetic", {}, {}}, {"elastic", {}, {}}};
  for (int i = 0; i <= 50; ++i) {
    for (Series& series : chart.series) series.x.push_back(0.02 * i);
    chart.series[0].y.push_back(std::exp(-0.1 * i));
    chart.series[1].y.push_back(1 - std::exp(-0.05 * i));
    chart.series[1].spread.push_back(0.05);
  }
  return chart;
}

}  // namespace

TEST_CASE("the view in space is as stored", "[golden]") {
  Snapshot snapshot = testing::layered_packing(1);
  const Image drawn = draw_particles(snapshot, layers_picture());
  const Image stored = golden("layers", drawn);
  CHECK(difference(drawn, stored) < threshold);

  Snapshot recoloured = snapshot;
  for (std::size_t row = 150; row < 152; ++row) recoloured.type[row] = 1 - recoloured.type[row];
  CHECK(difference(draw_particles(recoloured, layers_picture()), stored) > threshold);

  Snapshot moved = snapshot;
  moved.position.back().z() += 4 * moved.radius.back();
  CHECK(difference(draw_particles(moved, layers_picture()), stored) > threshold);
}

TEST_CASE("the slice is as stored", "[golden]") {
  const Snapshot snapshot = testing::layered_packing(1);
  const Image drawn = draw_slice(snapshot, {1, 0.3}, small_slice());
  const Image stored = golden("slice", drawn);
  CHECK(difference(drawn, stored) < threshold);
  CHECK(difference(draw_slice(snapshot, {1, 0.33}, small_slice()), stored) > threshold);
}

TEST_CASE("the chart is as stored", "[golden]") {
  Chart chart = small_chart();
  const Image drawn = draw_chart(chart);
  const Image stored = golden("chart", drawn);
  CHECK(difference(drawn, stored) < threshold);
  std::swap(chart.series[0].y, chart.series[1].y);
  CHECK(difference(draw_chart(chart), stored) > threshold);
}
