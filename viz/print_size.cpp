#include "viz/print_size.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::viz {

namespace {

constexpr double millimetres_per_inch = 25.4;
constexpr double points_per_inch = 72;
constexpr double thinnest_line_pt = 0.5;
constexpr double thinnest_outline_pt = 0.25;  ///< of discs, whose fill shows where they are

int whole_pixels(double millimetres, double dots_per_inch) {
  return static_cast<int>(std::lround(millimetres / millimetres_per_inch * dots_per_inch));
}

/// Thickens the strokes of marks [px].
struct Thickener {
  double line;
  double outline;

  void operator()(LineMark& mark) const { mark.stroke.width = std::max(mark.stroke.width, line); }
  void operator()(PolygonMark& mark) const {
    if (mark.outline) mark.outline->width = std::max(mark.outline->width, line);
  }
  void operator()(DiscMark& mark) const {
    if (mark.outline) mark.outline->width = std::max(mark.outline->width, outline);
  }
  template <class Strokeless>
  void operator()(Strokeless&) const {}
};

}  // namespace

int PrintSize::width() const { return whole_pixels(width_mm, dots_per_inch); }

int PrintSize::height() const { return whole_pixels(height_mm, dots_per_inch); }

double PrintSize::font() const { return font_pt / points_per_inch * dots_per_inch; }

void prepare_for_print(Drawing& drawing, const PrintSize& print) {
  const double point = print.dots_per_inch / points_per_inch;
  const Thickener thicken{thinnest_line_pt * point, thinnest_outline_pt * point};
  for (Mark& mark : drawing.marks) std::visit(thicken, mark);
  drawing.paper_size = PaperSize{print.width_mm, print.height_mm, print.dots_per_inch};
}

}  // namespace packstone::viz
