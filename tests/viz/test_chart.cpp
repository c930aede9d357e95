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

std::vector<LineMark> data_lines(const Chart& chart) {
  std::vector<LineMark> lines;
  bool in_plot = false;
  for (const Mark& mark : chart_drawing(chart).marks) {
    if (const auto* clip = std::get_if<ClipMark>(&mark)) in_plot = !clip->corners.empty();
    if (const auto* line = std::get_if<LineMark>(&mark); line != nullptr && in_plot) lines.push_back(*line);
  }
  return lines;
}

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
