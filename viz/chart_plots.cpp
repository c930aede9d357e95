#include "viz/chart_plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkTable.h>

#include "viz/band_plot.hpp"
#include "viz/drawing_device.hpp"

namespace packstone::viz {

namespace {

// As multiples of the font size.
constexpr double line_weight = 0.13;
constexpr double mark_diameter = 0.7;
constexpr double lone_diameter = 0.26;  ///< of a point between gaps
constexpr double bar_outline = 0.05;

constexpr double band_opacity = 0.2;
constexpr double bar_opacity = 0.65;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Point gap = {nan, nan};  ///< where VTK breaks a line

/// Line types of series of the same colour, by their round through the colours.
constexpr std::array line_types = {vtkPen::SOLID_LINE, vtkPen::DASH_LINE, vtkPen::DOT_LINE, vtkPen::DASH_DOT_LINE,
                                   vtkPen::DASH_DOT_DOT_LINE};

bool is_gap(const Point& point) { return std::isnan(point.x); }

/// Whether any two neighbours are joined.
bool has_line(const std::vector<Point>& course) {
  return std::adjacent_find(course.begin(), course.end(),
                            [](const Point& a, const Point& b) { return !is_gap(a) && !is_gap(b); }) != course.end();
}

void set_brush(vtkPlot& plot, Fill fill) {
  plot.GetBrush()->SetColor(fill.colour.r, fill.colour.g, fill.colour.b);
  plot.GetBrush()->SetOpacityF(fill.opacity);
}

/// Puts the data of one series or histogram into the chart.
class Plotter {
 public:
  Plotter(vtkChartXY& plots, const ChartOptions& options, const PlotFrame& frame)
      : plots_(plots), options_(options), frame_(frame) {}

  PlotGroup add(const Bars& bars, Colour colour) {
    const double ground = frame_.y.logarithmic ? frame_.y.low : 0;
    std::vector<Point> areas, outlines;
    for (std::size_t i = 0; i < bars.heights.size(); ++i) {
      const Point low = share(std::max(bars.edges[i], frame_.x.low), ground);
      const Point high = share(bars.edges[i + 1], std::max(bars.heights[i], ground));
      const Point upper_left = {low.x, high.y}, lower_right = {high.x, low.y};
      areas.insert(areas.end(), {low, upper_left, lower_right, high, gap});
      // The first side twice, so that the ends meet in a corner.
      outlines.insert(outlines.end(), {low, upper_left, high, lower_right, low, upper_left, gap});
    }
    PlotGroup group{.name = bars.name, .in_legend = {}};
    vtkPlot* filled = add_plot<BandPlot>(areas);
    set_brush(*filled, {colour, bar_opacity});
    group.in_legend.push_back(filled);
    set_pen(*add_plot<vtkPlotLine>(outlines), colour, bar_outline, vtkPen::SOLID_LINE);
    return group;
  }

  PlotGroup add(const Series& series, Colour colour, int line_type) {
    PlotGroup group{.name = series.name, .in_legend = {}, .line_alone = series.spread.empty() || series.marked};
    if (!series.spread.empty() && series.marked) add_error_bars(series, colour, line_type);
    if (!group.line_alone) {
      vtkPlot* band = add_plot<BandPlot>(spread(series));
      set_brush(*band, {colour, band_opacity});
      group.in_legend.push_back(band);
    }
    const std::vector<Point> line = course(series);
    if (!series.marked || has_line(line)) {
      group.in_legend.push_back(add_plot<vtkPlotLine>(line));
      set_pen(*group.in_legend.back(), colour, line_weight, line_type);
    }
    vtkPlot* discs = add_discs(series, colour);
    if (series.marked && discs != nullptr) group.in_legend.push_back(discs);
    return group;
  }

 private:
  Point share(double x, double y) const { return {frame_.x.share(x), frame_.y.share(y)}; }

  bool has_place(const Series& s, std::size_t i) const { return i < s.x.size() && drawable(s.x[i], s.y[i], options_); }

  /// With a gap at the end at least: of a line of a single point VTK would complain.
  std::vector<Point> course(const Series& s) const {
    std::vector<Point> points;
    for (std::size_t i = 0; i <= s.x.size(); ++i) points.push_back(has_place(s, i) ? share(s.x[i], s.y[i]) : gap);
    return points;
  }

  /// Of marked series at all points, of others where no line reaches; null where there are none.
  vtkPlot* add_discs(const Series& s, Colour colour) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const bool alone = !has_place(s, i + 1) && (i == 0 || !has_place(s, i - 1));
      if (has_place(s, i) && (s.marked || alone)) points.push_back(share(s.x[i], s.y[i]));
    }
    if (points.empty()) return nullptr;
    constexpr double disc_of_pen = 2.3;  // what VTK multiplies the width of a pen with, in plot and legend alike
    vtkPlot* discs = add_plot<vtkPlotPoints>(points);
    set_pen(*discs, colour, (s.marked ? mark_diameter : lone_diameter) / disc_of_pen, vtkPen::SOLID_LINE);
    return discs;
  }

  void add_error_bars(const Series& s, Colour colour, int line_type) {
    vtkPlotLine* bars = add_plot<vtkPlotLine>(spread(s));
    bars->SetPolyLine(false);
    set_pen(*bars, colour, line_weight, line_type);
  }

  /// Lower and upper end at each point in turn.
  std::vector<Point> spread(const Series& s) const {
    std::vector<Point> ends;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!has_place(s, i)) {
        if (!s.marked) ends.push_back(gap);
        continue;
      }
      const double half = std::isfinite(s.spread[i]) ? s.spread[i] : 0;
      for (const double shift : {-half, half}) {
        const double x = s.x[i] + (options_.profile ? shift : 0), y = s.y[i] + (options_.profile ? 0 : shift);
        ends.push_back(
            share(options_.log_x ? std::max(x, frame_.x.low) : x, options_.log_y ? std::max(y, frame_.y.low) : y));
      }
    }
    return ends;
  }

  void set_pen(vtkPlot& plot, Colour colour, double fonts, int line_type) const {
    plot.GetPen()->SetColor(colour.r, colour.g, colour.b);
    plot.GetPen()->SetWidth(DrawingDevice::units(fonts * frame_.font));
    plot.GetPen()->SetLineType(line_type);
  }

  template <class Plot>
  Plot* add_plot(const std::vector<Point>& points) {
    vtkNew<vtkDoubleArray> x, y;
    x->SetName("x");
    y->SetName("y");
    for (const Point& point : points) {
      x->InsertNextValue(point.x);
      y->InsertNextValue(point.y);
    }
    vtkNew<vtkTable> table;
    table->AddColumn(x);
    table->AddColumn(y);
    vtkNew<Plot> plot;
    plot->SetInputData(table, 0, 1);
    plots_.AddPlot(plot);
    return plot;
  }

  vtkChartXY& plots_;
  const ChartOptions& options_;
  const PlotFrame& frame_;
};

}  // namespace

bool drawable(double x, double y, const ChartOptions& options) {
  return std::isfinite(x) && std::isfinite(y) && (!options.log_x || x > 0) && (!options.log_y || y > 0);
}

std::vector<PlotGroup> add_plots(vtkChartXY& plots, const Chart& chart, const PlotFrame& frame) {
  Plotter plotter(plots, chart.options, frame);
  std::vector<PlotGroup> groups;
  for (std::size_t i = 0; i < chart.bars.size(); ++i) groups.push_back(plotter.add(chart.bars[i], category_colour(i)));
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    groups.push_back(
        plotter.add(series, series.colour.value_or(line_colour(i)), line_types[line_round(i) % line_types.size()]));
  }
  return groups;
}

}  // namespace packstone::viz
