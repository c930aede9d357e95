// The axes of a chart, which VTK paints.
#pragma once

#include "viz/plot_frame.hpp"

class vtkChartXY;

namespace packstone::viz {

/// Gives the chart the frame's scales, ticks and labels. What is plotted has to be given as shares of the axes
/// (AxisScale::share): of values, whose axis may be narrow beside its distance from 0, VTK 9.1 takes an offset off, but
/// only from the second painting on, and on a logarithmic axis ahead of the logarithm.
void set_axes(vtkChartXY& chart, const PlotFrame& frame);

}  // namespace packstone::viz
