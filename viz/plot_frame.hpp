// Axes around a plot. Slices draw them here; charts have VTK draw them, to the same measures (chart_axes.hpp).
#pragma once

#include <string>

#include "viz/drawing.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

/// Of axes, as multiples of the font size.
namespace axis_measure {
inline constexpr double tick_length = 0.35;
inline constexpr double number_gap = 0.35;
inline constexpr double label_gap = 0.9;
inline constexpr double line_weight = 0.07;
}  // namespace axis_measure

/// The range of values an axis shows.
struct AxisScale {
  double low = 0;
  double high = 1;
  bool logarithmic = false;

  /// 0 at low, 1 at high.
  double share(double value) const;
};

/// A plot's place in the drawing, its scales, and what stands at them.
struct PlotFrame {
  Box box;
  AxisScale x;
  AxisScale y;
  std::string x_label;  ///< with the unit: "Time [s]"
  std::string y_label;
  double font = 12;  ///< [px]

  Point place(double x_value, double y_value) const;
};

/// Room for ticks, numbers and label at the left of a plot of this height [px].
double left_room(const AxisScale& y, double height, double font);
/// The same below a plot.
double lower_room(double font);

/// As many as the plot has room for.
Ticks x_ticks(const PlotFrame& frame);
Ticks y_ticks(const PlotFrame& frame);

/// Frame, ticks, numbers and labels; drawn after the data.
void draw_axes(Drawing& drawing, const PlotFrame& frame);

}  // namespace packstone::viz
