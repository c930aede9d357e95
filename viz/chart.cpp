#include "viz/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
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
constexpr double line_weight = 0.13;
constexpr double mark_radius = 0.35;
constexpr double bar_outline = 0.05;

constexpr double band_opacity = 0.2;
constexpr double bar_opacity = 0.65;
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

bool drawable(double x, double y, const ChartOptions& options) {
  return std::isfinite(x) && std::isfinite(y) && (!options.log_x || x > 0) && (!options.log_y || y > 0);
}

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

Colour colour_of(const Series& series, std::size_t index) { return series.colour.value_or(line_colour(index)); }

Stroke line_stroke(const Series& series, std::size_t index, double font) {
  constexpr double dash = 0.5;
  Stroke stroke{colour_of(series, index), line_weight * font, {}};
  const auto round = static_cast<double>(line_round(index));
  if (round > 0) stroke.dashes = {dash * font * (1 + round), dash * font};
  return stroke;
}

struct Key {
  std::string name;
  std::optional<Fill> fill;
  std::optional<Stroke> stroke;
};

std::vector<Key> keys(const Chart& chart, double font) {
  std::vector<Key> result;
  for (std::size_t i = 0; i < chart.bars.size(); ++i) {
    result.push_back({chart.bars[i].name, Fill{category_colour(i), bar_opacity}, std::nullopt});
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    result.push_back({chart.series[i].name, std::nullopt, line_stroke(chart.series[i], i, font)});
    if (!chart.series[i].spread.empty() && !chart.series[i].marked)
      result.back().fill = Fill{colour_of(chart.series[i], i), band_opacity};
  }
  std::erase_if(result, [](const Key& key) { return key.name.empty(); });
  if (result.size() == 1 && !result.front().fill) result.clear();  // the axis says it already
  return result;
}

/// Entries side by side above the plot, in as many lines as they need; returns the y below them.
double draw_keys(Drawing& drawing, const std::vector<Key>& entries, double left, double top, double right,
                 double font) {
  if (entries.empty()) return top;
  double x = left;
  double y = top;
  for (const Key& key : entries) {
    const double width = (key_length + key_gap) * font + text_width(key.name, font);
    if (x > left && x + width > right) {
      x = left;
      y += legend_line * font;
    }
    const double middle = y + capital_height / 2 * font;
    const double half = capital_height / 2 * font;
    if (key.fill) drawing.rectangle({x, middle - half, x + key_length * font, middle + half}, key.fill, std::nullopt);
    if (key.stroke) drawing.line({x, middle}, {x + key_length * font, middle}, *key.stroke);
    drawing.text({x + (key_length + key_gap) * font, middle}, key.name, {.size = font, .along = Side::middle});
    x += width + entry_gap * font;
  }
  return y + legend_line * font;
}

/// The runs of a series without a gap, as row ranges [first, last).
std::vector<std::pair<std::size_t, std::size_t>> runs(const Series& s, const ChartOptions& options) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  bool open = false;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const bool good = drawable(s.x[i], s.y[i], options);
    if (good && !open) result.emplace_back(i, i);
    if (good) result.back().second = i + 1;
    open = good;
  }
  return result;
}

/// A band around a line, or a bar at each mark.
void draw_spread(Drawing& drawing, const PlotFrame& frame, const Series& s, std::pair<std::size_t, std::size_t> run,
                 const ChartOptions& options, Fill fill, const Stroke& stroke) {
  std::vector<Point> sides[2];
  for (std::size_t i = run.first; i < run.second; ++i) {
    for (int k = 0; k < 2; ++k) {
      const double shift = std::isfinite(s.spread[i]) ? (k == 0 ? -s.spread[i] : s.spread[i]) : 0;
      const double y = s.y[i] + (options.profile ? 0 : shift);
      const double x = s.x[i] + (options.profile ? shift : 0);
      sides[k].push_back(
          frame.place(options.log_x ? std::max(x, frame.x.low) : x, options.log_y ? std::max(y, frame.y.low) : y));
    }
  }
  if (!s.marked) {
    drawing.band(sides[0], sides[1], fill);
    return;
  }
  for (std::size_t i = 0; i < sides[0].size(); ++i) drawing.line(sides[0][i], sides[1][i], stroke);
}

void draw_data(Drawing& drawing, const PlotFrame& frame, const Chart& chart) {
  const double font = frame.font;
  drawing.clip(frame.box);
  for (std::size_t k = 0; k < chart.bars.size(); ++k) {
    const Bars& b = chart.bars[k];
    const double ground = frame.y.logarithmic ? frame.y.low : 0;
    for (std::size_t i = 0; i < b.heights.size(); ++i) {
      const Point a = frame.place(std::max(b.edges[i], frame.x.low), std::max(b.heights[i], ground));
      const Point c = frame.place(b.edges[i + 1], ground);
      drawing.rectangle({a.x, a.y, c.x, c.y}, Fill{category_colour(k), bar_opacity},
                        Stroke{category_colour(k), bar_outline * font, {}});
    }
  }
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    const Series& s = chart.series[k];
    const auto pieces = runs(s, chart.options);
    for (const auto& run : pieces) {
      if (s.spread.empty()) continue;
      draw_spread(drawing, frame, s, run, chart.options, Fill{colour_of(s, k), band_opacity}, line_stroke(s, k, font));
    }
    for (const auto& [first, last] : pieces) {
      std::vector<Point> points;
      for (std::size_t i = first; i < last; ++i) points.push_back(frame.place(s.x[i], s.y[i]));
      if (points.size() > 1) drawing.polyline(points, line_stroke(s, k, font));
      if (points.size() > 1 && !s.marked) continue;
      for (const Point& point : points) {
        drawing.disc(point, (s.marked ? mark_radius : line_weight) * font, Fill{colour_of(s, k)}, std::nullopt);
      }
    }
  }
  drawing.end_clip();
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
  top = draw_keys(drawing, keys(chart, font), left, top, right, font);
  if (right <= left || bottom <= top) {
    throw InputError(fmt::format("a chart of {} x {} px has no room beside its labels", options.width, options.height));
  }
  frame.box = {left, top, right, bottom};
  draw_grid(drawing, frame);
  draw_data(drawing, frame, chart);
  draw_axes(drawing, frame);
  return drawing;
}

Image draw_chart(const Chart& chart) { return draw_image(chart_drawing(chart), chart.options.supersampling); }

}  // namespace packstone::viz
