// Axes around a plot: charts and slices share them.
#pragma once

#include <string>

#include "viz/drawing.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

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

/// Light lines across the plot at the ticks; drawn before the data.
void draw_grid(Drawing& drawing, const PlotFrame& frame);

/// Frame, ticks, numbers and labels; drawn after the data.
void draw_axes(Drawing& drawing, const PlotFrame& frame);

}  // namespace packstone::viz
