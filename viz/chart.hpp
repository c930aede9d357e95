// Charts for papers and reports: lines, profiles with their spread, histograms.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viz/drawing.hpp"
#include "viz/image.hpp"
#include "viz/style.hpp"

namespace packstone::viz {

/// A line through points. It is broken where a value is not finite, or not positive on a logarithmic axis.
struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> spread = {};  ///< half width of a band around the line; empty for none
  std::optional<Colour> colour =
      std::nullopt;     ///< by default the next of line_colour(); category_colour(i) matches pictures
  bool marked = false;  ///< a disc and an error bar at each point: values measured one by one, not a course
};

/// A histogram: bar i stands between edges i and i + 1.
struct Bars {
  std::string name;
  std::vector<double> edges;
  std::vector<double> heights;
};

struct ChartOptions {
  std::string title;
  std::string x_label;  ///< with the unit: "Time [s]"
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  bool profile = false;                              ///< y is the position (a height), so spreads lie along x
  std::optional<std::pair<double, double>> x_range;  ///< the data's own by default
  std::optional<std::pair<double, double>> y_range;
  int width = 1600;   ///< [px]
  int height = 1000;  ///< [px]
  int supersampling = 2;
  double font_scale = 1;  ///< of the usual size for the picture
  double margin = usual_margin;
};

struct Chart {
  ChartOptions options;
  std::vector<Series> series;
  std::vector<Bars> bars;
};

/// For svg_text or save_drawing. Throws InputError when lengths disagree or there is nothing to show.
Drawing chart_drawing(const Chart& chart);

/// The same as pixels.
Image draw_chart(const Chart& chart);

}  // namespace packstone::viz
