#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "viz/chart.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

Chart chart_of(const Series& series) {
  Chart chart;
  chart.options.x_label = "Time [s]";
  chart.options.y_label = "Energy [J]";
  chart.series = {series};
  return chart;
}

/// Without the grid, which is clipped as the data are.
std::vector<LineMark> data_lines(const Chart& chart) {
  std::vector<LineMark> lines;
  bool in_plot = false;
  for (const Mark& mark : chart_drawing(chart).marks) {
    if (const auto* clip = std::get_if<ClipMark>(&mark)) in_plot = !clip->corners.empty();
    const auto* line = std::get_if<LineMark>(&mark);
    if (line != nullptr && in_plot && line->stroke.colour != grid_line) lines.push_back(*line);
  }
  return lines;
}

template <class Kind>
std::vector<Kind> marks_of(const Chart& chart) {
  std::vector<Kind> found;
  for (const Mark& mark : chart_drawing(chart).marks) {
    if (const auto* one = std::get_if<Kind>(&mark)) found.push_back(*one);
  }
  return found;
}

/// The box around the plot, which is drawn last.
Box frame_of(const Chart& chart) {
  const PolygonMark frame = marks_of<PolygonMark>(chart).back();
  return {frame.corners[0].x, frame.corners[0].y, frame.corners[2].x, frame.corners[2].y};
}

constexpr double tolerance = 0.05;  ///< [px]

const Chart histogram = [] {
  Chart chart;
  chart.bars = {{"radii", {0, 1, 3, 4}, {2, 4, 1}}};
  return chart;
}();

}  // namespace

TEST_CASE("a line is broken where there is no value") {
  const Series series{"e", {0, 1, 2, 3, 4, 5}, {1, 2, std::nan(""), 4, 5, 6}};
  const auto lines = data_lines(chart_of(series));
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].points.size() == 2);
  CHECK(lines[1].points.size() == 3);
}

TEST_CASE("a logarithmic axis leaves out what is not positive") {
  Chart chart = chart_of({"e", {0, 1, 2, 3}, {1, 10, 0, 100}});
  chart.options.log_y = true;
  const auto lines = data_lines(chart);
  REQUIRE(lines.size() == 1);
  chart.series[0].y = {1, 10, 100, 1000};
  const auto straight = data_lines(chart).front().points;
  CHECK(straight[1].y - straight[0].y == Approx(straight[3].y - straight[2].y));
}

TEST_CASE("both axes can be logarithmic: a power law is a straight line") {
  Chart chart = chart_of({"e", {0, 1, 10, 100}, {1, 1, 100, 10000}});
  chart.options.log_x = chart.options.log_y = true;
  const auto lines = data_lines(chart);
  REQUIRE(lines.size() == 1);
  const auto& points = lines.front().points;
  REQUIRE(points.size() == 3);
  CHECK(points[1].x - points[0].x == Approx(points[2].x - points[1].x));
  CHECK(points[1].y - points[0].y == Approx(points[2].y - points[1].y));
}

TEST_CASE("a series keeps the colour it is given") {
  Series series{"light", {0, 1}, {1, 2}};
  series.colour = category_colour(0);
  CHECK(data_lines(chart_of(series)).front().stroke.colour == category_colour(0));
}

TEST_CASE("charts that cannot be drawn are refused") {
  CHECK_THROWS_AS(chart_drawing(chart_of({"e", {0, 1}, {1}})), InputError);
  CHECK_THROWS_AS(chart_drawing(chart_of({"e", {}, {}})), InputError);
  CHECK_THROWS_AS(chart_drawing(chart_of({"e", {0}, {std::nan("")}})), InputError);
  Chart bars;
  bars.bars = {{"f", {0, 1}, {1, 2}}};
  CHECK_THROWS_AS(chart_drawing(bars), InputError);
  Chart range = chart_of({"e", {0, 1}, {1, 2}});
  range.options.y_range = {2, 1};
  CHECK_THROWS_AS(chart_drawing(range), InputError);
}

TEST_CASE("a constant series and a single point are drawn") {
  CHECK_NOTHROW(chart_drawing(chart_of({"e", {0, 1}, {0, 0}})));
  CHECK_NOTHROW(chart_drawing(chart_of({"e", {3}, {-7}})));
  Chart logarithmic = chart_of({"e", {3, 4}, {10, 10}});
  logarithmic.options.log_y = true;
  CHECK_NOTHROW(chart_drawing(logarithmic));
}

TEST_CASE("values lie where the axes have them, ever so narrow ranges too") {
  const auto [low, high] = GENERATE(std::pair{0.0, 1.0}, std::pair{-3.0, 5e6}, std::pair{5.0, 5 + 1e-7},
                                    std::pair{1e6, 1e6 + 1}, std::pair{-2e-9, -1e-9});
  Chart chart = chart_of({"e", {low, high}, {low, low + (high - low) / 4}});
  chart.options.x_range = chart.options.y_range = {low, high};
  const Box frame = frame_of(chart);
  const auto points = data_lines(chart).front().points;
  CHECK(points[0].x == Approx(frame.left).margin(tolerance));
  CHECK(points[0].y == Approx(frame.bottom).margin(tolerance));
  CHECK(points[1].x == Approx(frame.right).margin(tolerance));
  CHECK(points[1].y == Approx(frame.bottom - frame.height() / 4).margin(tolerance));
}

TEST_CASE("a logarithmic axis begins and ends anywhere") {
  const auto [low, high] = GENERATE(std::pair{1.02, 1000.0}, std::pair{1e-8, 1.1e-8}, std::pair{3e-12, 7e9});
  Chart chart = chart_of({"e", {0, 1, 2}, {low, std::sqrt(low * high), high}});
  chart.options.log_y = true;
  chart.options.y_range = {low, high};
  const Box frame = frame_of(chart);
  const auto points = data_lines(chart).front().points;
  CHECK(points[0].y == Approx(frame.bottom).margin(tolerance));
  CHECK(points[1].y == Approx(frame.centre().y).margin(tolerance));
  CHECK(points[2].y == Approx(frame.top).margin(tolerance));
}

TEST_CASE("the spread is a band beside the line, in a profile across it") {
  Chart chart = chart_of({"e", {1, 2, 3}, {4, 5, 6}, {0.5, 0.5, 0.5}});
  const auto upright = marks_of<BandMark>(chart);
  REQUIRE(upright.size() == 1);
  REQUIRE(upright[0].first.size() == 3);
  CHECK(upright[0].first[1].x == Approx(upright[0].second[1].x));
  CHECK(upright[0].first[1].y > upright[0].second[1].y);
  chart.options.profile = true;
  const auto beside = marks_of<BandMark>(chart);
  REQUIRE(beside.size() == 1);
  CHECK(beside[0].first[1].y == Approx(beside[0].second[1].y));
  CHECK(beside[0].first[1].x < beside[0].second[1].x);
}

TEST_CASE("a band is broken where the line is") {
  CHECK(marks_of<BandMark>(chart_of({"e", {0, 1, 2, 3, 4}, {1, 2, std::nan(""), 4, 5}, {1, 1, 1, 1, 1}})).size() == 2);
}

TEST_CASE("marked points have discs and error bars") {
  Series series{.name = "e", .x = {1, 2, 3}, .y = {4, 5, 6}, .spread = {0.5, std::nan(""), 1}, .marked = true};
  const Chart chart = chart_of(series);
  CHECK(marks_of<DiscMark>(chart).size() == 3);
  CHECK(marks_of<BandMark>(chart).empty());
  const auto lines = data_lines(chart);
  REQUIRE(lines.size() == 4);  // three bars, of which that without a length shows nothing, and the line
  CHECK(lines[0].points[0].x == Approx(lines[0].points[1].x));
  CHECK(lines[2].points[0].y - lines[2].points[1].y == Approx(2 * (lines[0].points[0].y - lines[0].points[1].y)));
  CHECK(lines[3].points.size() == 3);
}

TEST_CASE("a point between gaps is a disc, as no line would show it") {
  const double gap = std::nan("");
  CHECK(marks_of<DiscMark>(chart_of({"e", {0, 1, 2, 3, 4}, {1, gap, 2, gap, 3}})).size() == 3);
  CHECK(marks_of<DiscMark>(chart_of({"e", {0, 1, 2, 3, 4}, {1, 2, gap, 3, 4}})).empty());
}

TEST_CASE("bars stand between their edges, on 0 or on the foot of a logarithmic axis") {
  Chart chart = histogram;
  const auto bars = marks_of<BandMark>(chart);
  REQUIRE(bars.size() == 3);
  const auto width = [](const BandMark& bar) { return bar.first[1].x - bar.first[0].x; };
  CHECK(width(bars[1]) == Approx(2 * width(bars[0])).margin(tolerance));
  const auto height = [](const BandMark& bar) { return bar.first[0].y - bar.second[0].y; };
  CHECK(height(bars[1]) == Approx(2 * height(bars[0])).margin(tolerance));
  CHECK(width(bars[0]) > 0);
  CHECK(height(bars[0]) > 0);
  CHECK(bars[0].first[1].x == Approx(bars[1].first[0].x));
  CHECK(bars[0].first[0].y == Approx(frame_of(chart).bottom).margin(tolerance));
  chart.options.log_y = true;
  CHECK(marks_of<BandMark>(chart)[0].first[0].y == Approx(frame_of(chart).bottom).margin(tolerance));
}

TEST_CASE("lines of one colour differ in their dashes") {
  Chart chart;
  constexpr std::size_t rounds = 5;
  std::size_t colours = 1;
  while (line_round(colours) == 0) ++colours;
  for (std::size_t i = 0; i < rounds * colours; ++i) chart.series.push_back({"e", {0, 1}, {1, 2}});
  const auto lines = data_lines(chart);
  REQUIRE(lines.size() == rounds * colours);
  CHECK(lines[0].stroke.dashes.empty());
  for (std::size_t i = colours; i < lines.size(); i += colours) {
    CHECK(lines[i].stroke.colour == lines[0].stroke.colour);
    for (std::size_t before = 0; before < i; before += colours) {
      CHECK(lines[i].stroke.dashes != lines[before].stroke.dashes);
    }
  }
}

TEST_CASE("the legend stands above the plot and shows what is plotted") {
  Chart chart = chart_of({"first", {0, 1}, {1, 2}});
  const auto names = [&] {
    std::vector<TextMark> found;
    for (const TextMark& text : marks_of<TextMark>(chart)) {
      if (text.text == "first" || text.text == "second") found.push_back(text);
    }
    return found;
  };
  CHECK(names().empty());
  chart.series.push_back({.name = "second", .x = {0}, .y = {2}, .marked = true});
  REQUIRE(names().size() == 2);
  const Box frame = frame_of(chart);
  for (const TextMark& name : names()) {
    CHECK(name.at.y < frame.top);
    CHECK(name.at.x > frame.left);
  }
  const auto discs = marks_of<DiscMark>(chart);
  REQUIRE(discs.size() == 2);
  CHECK(discs[0].centre.y == Approx(names()[1].at.y).margin(tolerance));
  CHECK(discs[0].radius == Approx(discs[1].radius));
}

TEST_CASE("numbers stand at the ticks, the titles beyond them") {
  const Chart chart = chart_of({"e", {0, 10}, {0, 2e-5}});
  const Box frame = frame_of(chart);
  const double font = font_size(chart.options.width, chart.options.height);
  const auto texts = marks_of<TextMark>(chart);
  const auto find = [&](const std::string& text) {
    for (const TextMark& mark : texts) {
      if (mark.text == text) return mark;
    }
    FAIL("no " << text);
    return TextMark{};
  };
  const TextMark time = find("Time [s]"), energy = find("Energy [10\u207b\u2075 J]"), ten = find("10");
  CHECK(ten.at.x == Approx(frame.right).margin(tolerance));
  CHECK(ten.at.y == Approx(frame.bottom + 0.7 * font).margin(tolerance));
  CHECK(ten.style.size == Approx(font).margin(tolerance));
  CHECK(time.at.x == Approx(frame.centre().x).margin(tolerance));
  CHECK(time.at.y == Approx(frame.bottom + (1.6 + 0.73) * font).margin(tolerance));
  CHECK(energy.at.y == Approx(frame.centre().y).margin(tolerance));
  CHECK(energy.style.upward);
  CHECK(energy.at.x == Approx(frame.left - 1.6 * font - text_width("0.0", font)).margin(tolerance));
}
