#include "viz/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPlot.h>
#include <vtkRect.h>

#include "core/error.hpp"
#include "viz/chart_axes.hpp"
#include "viz/chart_plots.hpp"
#include "viz/drawing_device.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/font.hpp"
#include "viz/plot_frame.hpp"

namespace packstone::viz {

namespace {

// All as multiples of the font size.
constexpr double last_number_room = 1.2;  ///< for half of what stands at the axis' end
constexpr double title_size = 1.15;
constexpr double title_room = 2.0;
constexpr double key_length = 2.0;  ///< of the piece of line in the legend
constexpr double key_gap = 0.6;
constexpr double entry_gap = 2.0;
constexpr double legend_line = 1.7;

constexpr double headroom = 0.04;   ///< of the range, beyond the data
constexpr double near_zero = 0.35;  ///< an axis whose lowest value is below this share of the highest begins at 0

/// Smallest range of the finite values seen.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

void check(const Chart& chart) {
  for (const Series& s : chart.series) {
    if (s.x.size() != s.y.size() || (!s.spread.empty() && s.spread.size() != s.x.size())) {
      throw InputError(fmt::format("the series '{}' has {} x, {} y and {} spread values; their numbers must agree",
                                   s.name, s.x.size(), s.y.size(), s.spread.size()));
    }
  }
  for (const Bars& b : chart.bars) {
    if (b.edges.size() != b.heights.size() + 1) {
      throw InputError(fmt::format("the histogram '{}' has {} edges for {} bars; {} would be right", b.name,
                                   b.edges.size(), b.heights.size(), b.heights.size() + 1));
    }
  }
}

void measure(const Chart& chart, Extent& x, Extent& y) {
  const ChartOptions& options = chart.options;
  for (const Series& s : chart.series) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!drawable(s.x[i], s.y[i], options)) continue;
      const double spread = s.spread.empty() || !std::isfinite(s.spread[i]) ? 0 : s.spread[i];
      for (const double side : {-spread, spread}) {
        const double across = s.x[i] + (options.profile ? side : 0), up = s.y[i] + (options.profile ? 0 : side);
        if (!options.log_x || across > 0) x.add(across);
        if (!options.log_y || up > 0) y.add(up);
      }
    }
  }
  for (const Bars& b : chart.bars) {
    for (const double edge : b.edges) {
      if (!options.log_x || edge > 0) x.add(edge);
    }
    for (const double height : b.heights) y.add(height);
    if (!options.log_y) y.add(0);
  }
}

/// A readable range around the values: from 0 where that is near, with some headroom.
AxisScale linear_scale(Extent values, bool tight) {
  if (values.low == values.high) {
    const double pad = values.low == 0 ? 1 : std::abs(values.low) * headroom;
    return {values.low - pad, values.high + pad, false};
  }
  if (values.low > 0 && values.low < near_zero * values.high) values.low = 0;
  if (values.high < 0 && values.high > near_zero * values.low) values.high = 0;
  const double pad = tight ? 0 : headroom * (values.high - values.low);
  return {values.low == 0 ? 0 : values.low - pad, values.high == 0 ? 0 : values.high + pad, false};
}

/// Whole decades.
AxisScale logarithmic_scale(const Extent& values) {
  const double low = std::floor(std::log10(values.low));
  const double high = std::max(low + 1, std::ceil(std::log10(values.high)));
  return {std::pow(10.0, low), std::pow(10.0, high), true};
}

void override_range(AxisScale& scale, const std::optional<std::pair<double, double>>& range, const char* axis) {
  if (!range) return;
  if (!(range->first < range->second) || (scale.logarithmic && range->first <= 0)) {
    throw InputError(fmt::format("the chart's {} range {} to {} is not ascending{}", axis, range->first, range->second,
                                 scale.logarithmic ? ", or not positive" : ""));
  }
  scale.low = range->first;
  scale.high = range->second;
}

/// VTK's chart, and what makes marks of it.
struct Canvas {
  Drawing& drawing;
  vtkNew<DrawingDevice> device;
  vtkNew<vtkContext2D> painter;
  vtkNew<vtkContextScene> scene;  // axes ask it for their scale
  vtkNew<vtkChartXY> plots;

  explicit Canvas(Drawing& target) : drawing(target) {
    device->record_into(drawing);
    painter->Begin(device);
    scene->AddItem(plots);
  }

  void paint(const PlotFrame& frame) {
    plots->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    plots->SetSize(device->units(frame.box));
    set_axes(*plots, frame);
    plots->Paint(painter);
    drawing.rectangle(frame.box, std::nullopt, Stroke{ink, axis_measure::line_weight * frame.font, {}});
  }
};

/// Entries side by side above the plot, in as many lines as they need, while VTK's legend is a column on top of the
/// data; returns the y below them.
double draw_legend(Canvas& canvas, std::vector<PlotGroup> entries, double left, double top, double right, double font) {
  std::erase_if(entries, [](const PlotGroup& entry) { return entry.name.empty(); });
  // Of one line the axis says it already.
  if (entries.empty() || (entries.size() == 1 && entries.front().line_alone)) return top;
  const double length = key_length * font, height = capital_height * font;
  double x = left;
  double y = top;
  for (const PlotGroup& entry : entries) {
    const double width = (key_length + key_gap) * font + text_width(entry.name, font);
    if (x > left && x + width > right) {
      x = left;
      y += legend_line * font;
    }
    const vtkRectf key = canvas.device->units(Box{x, y, x + length, y + height});
    for (vtkPlot* plot : entry.in_legend) plot->PaintLegend(canvas.painter, key, 0);
    canvas.drawing.text({x + (key_length + key_gap) * font, y + height / 2}, entry.name,
                        {.size = font, .along = Side::middle});
    x += width + entry_gap * font;
  }
  return y + legend_line * font;
}

}  // namespace

Drawing chart_drawing(const Chart& chart) {
  check(chart);
  const ChartOptions& options = chart.options;
  Extent x;
  Extent y;
  measure(chart, x, y);
  if (x.empty() || y.empty()) throw InputError(fmt::format("the chart '{}' has no values to show", options.title));
  PlotFrame frame;
  frame.font = font_size(options.width, options.height) * options.font_scale;
  frame.x = options.log_x ? logarithmic_scale(x) : linear_scale(x, !options.profile);
  frame.y = options.log_y ? logarithmic_scale(y) : linear_scale(y, options.profile);
  override_range(frame.x, options.x_range, "x");
  override_range(frame.y, options.y_range, "y");
  frame.x_label = options.x_label;
  frame.y_label = options.y_label;

  const double font = frame.font;
  Drawing drawing{options.width, options.height, {}};
  Canvas canvas(drawing);
  const auto groups = add_plots(*canvas.plots, chart, frame);

  const double edge = options.margin * font;
  double top = edge;
  const double bottom = options.height - edge - lower_room(font);
  const double left = edge + left_room(frame.y, bottom - top, font);
  const double right = options.width - edge - last_number_room * font;
  if (!options.title.empty()) {
    drawing.text({(left + right) / 2, top}, options.title,
                 {.size = title_size * font, .across = Side::middle, .along = Side::high, .bold = true});
    top += title_room * font;
  }
  top = draw_legend(canvas, groups, left, top, right, font);
  if (right <= left || bottom <= top) {
    throw InputError(fmt::format("a chart of {} x {} px has no room beside its labels", options.width, options.height));
  }
  frame.box = {left, top, right, bottom};
  canvas.paint(frame);
  return drawing;
}

Image draw_chart(const Chart& chart) { return draw_image(chart_drawing(chart), chart.options.supersampling); }

}  // namespace packstone::viz
