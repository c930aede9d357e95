#include "viz/chart_axes.hpp"

#include <algorithm>
#include <cmath>

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkStringArray.h>
#include <vtkTextProperty.h>

#include "viz/drawing_device.hpp"

namespace packstone::viz {

namespace {

using namespace axis_measure;

constexpr double grid_weight = 0.05;          ///< of the font size
constexpr double title_distance_of_vtk = 10;  ///< [units], from the axis, besides the widest number

void set_pen(vtkPen& pen, Colour colour, double width) {
  pen.SetColor(colour.r, colour.g, colour.b);
  pen.SetWidth(DrawingDevice::units(width));
}

void set_text(vtkTextProperty& text, double font) {
  constexpr double full = 255;
  text.SetColor(ink.r / full, ink.g / full, ink.b / full);
  text.SetFontSize(static_cast<int>(std::lround(DrawingDevice::units(font))));
  text.SetBold(0);
}

void set_ticks(vtkAxis& axis, const AxisScale& scale, const Ticks& ticks) {
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    places->InsertNextValue(std::clamp(scale.share(ticks.values[i]), 0.0, 1.0));  // VTK leaves out what is beyond
    labels->InsertNextValue(ticks.labels[i]);
  }
  axis.SetCustomTickPositions(places, labels);
}

void set_axis(vtkAxis& axis, const AxisScale& scale, const Ticks& ticks, const std::string& label, double font) {
  axis.SetBehavior(vtkAxis::CUSTOM);
  axis.SetRange(0, 1);
  set_ticks(axis, scale, ticks);
  axis.SetTitle(with_exponent(label, ticks.exponent));
  axis.SetAxisVisible(false);  // four lines would not meet in corners: chart_drawing() draws one frame
  axis.SetTickLength(DrawingDevice::units(tick_length * font));
  axis.SetLabelOffset(DrawingDevice::units((tick_length + number_gap) * font));
  set_pen(*axis.GetPen(), ink, line_weight * font);  // of ticks
  set_pen(*axis.GetGridPen(), grid_line, grid_weight * font);
  set_text(*axis.GetLabelProperties(), font);
  set_text(*axis.GetTitleProperties(), font);
  const double away = DrawingDevice::units((tick_length + number_gap + label_gap) * font) - title_distance_of_vtk;
  axis.GetTitleProperties()->SetLineOffset(axis.GetPosition() == vtkAxis::LEFT ? away : -away);
}

}  // namespace

void set_axes(vtkChartXY& chart, const PlotFrame& frame) {
  chart.SetAutoAxes(false);
  set_axis(*chart.GetAxis(vtkAxis::BOTTOM), frame.x, x_ticks(frame), frame.x_label, frame.font);
  set_axis(*chart.GetAxis(vtkAxis::LEFT), frame.y, y_ticks(frame), frame.y_label, frame.font);
}

}  // namespace packstone::viz
