// The area between two lines, as a plot of VTK's.
#pragma once

#include <vtkPlotPoints.h>

namespace packstone::viz {

/// Filled by the brush between two lines, whose points are given in turn: one's first, the other's first, one's second
/// and so on; a single point that is not a number parts areas. vtkPlotArea has lines one above the other alone, while
/// the spread of a profile lies beside it, and vtkPlotBar has bars of one width.
class BandPlot : public vtkPlotPoints {
 public:
  static BandPlot* New();
  vtkTypeMacro(BandPlot, vtkPlotPoints)

      bool Paint(vtkContext2D* painter) override;
  bool PaintLegend(vtkContext2D* painter, const vtkRectf& box, int index) override;

 protected:
  BandPlot() = default;
  ~BandPlot() override = default;
};

}  // namespace packstone::viz
