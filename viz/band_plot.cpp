#include "viz/band_plot.hpp"

#include <cmath>
#include <cstddef>

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPoints2D.h>
#include <vtkRect.h>

namespace packstone::viz {

vtkStandardNewMacro(BandPlot)

    bool BandPlot::Paint(vtkContext2D* painter) {
  constexpr std::ptrdiff_t smallest = 4;  // two points of each line
  painter->ApplyBrush(Brush);
  auto* coordinates = static_cast<float*>(Points->GetVoidPointer(0));
  const std::ptrdiff_t count = Points->GetNumberOfPoints();
  std::ptrdiff_t first = 0;
  for (std::ptrdiff_t i = 0; i <= count; ++i) {
    if (i < count && !std::isnan(coordinates[2 * i] + coordinates[2 * i + 1])) continue;
    if (i - first >= smallest) painter->DrawQuadStrip(coordinates + 2 * first, static_cast<int>(i - first));
    first = i + 1;
  }
  return true;
}

bool BandPlot::PaintLegend(vtkContext2D* painter, const vtkRectf& box, int /*index*/) {
  painter->ApplyBrush(Brush);
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->DrawRect(box.GetX(), box.GetY(), box.GetWidth(), box.GetHeight());
  return true;
}

}  // namespace packstone::viz
