// Series and histograms as plots of VTK's.
#pragma once

#include <string>
#include <vector>

#include "viz/chart.hpp"
#include "viz/plot_frame.hpp"

class vtkChartXY;
class vtkPlot;

namespace packstone::viz {

/// Whether a point has a place on the chart's axes.
bool drawable(double x, double y, const ChartOptions& options);

/// What stands for one series or histogram: plots that are painted over one another, in the plot and in the legend.
struct PlotGroup {
  std::string name;
  std::vector<vtkPlot*> in_legend;  ///< the chart's
  bool line_alone = false;          ///< nothing but a line
};

/// Adds the histograms and series, later ones above, in this order. The chart's axes must be those of set_axes(); of
/// the frame, scales and font count.
std::vector<PlotGroup> add_plots(vtkChartXY& plots, const Chart& chart, const PlotFrame& frame);

}  // namespace packstone::viz
