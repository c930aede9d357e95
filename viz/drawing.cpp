#include "viz/drawing.hpp"

#include <cmath>
#include <memory>

#include <cairo/cairo.h>

#include "viz/font.hpp"

namespace packstone::viz {

void Drawing::polyline(const std::vector<Point>& points, const Stroke& stroke) {
  marks.emplace_back(LineMark{points, stroke});
}

void Drawing::rectangle(const Box& box, std::optional<Fill> fill, const std::optional<Stroke>& outline) {
  polygon({{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}, fill, outline);
}

void Drawing::polygon(const std::vector<Point>& corners, std::optional<Fill> fill,
                      const std::optional<Stroke>& outline) {
  marks.emplace_back(PolygonMark{corners, fill, outline});
}

void Drawing::disc(Point centre, double radius, Fill fill, const std::optional<Stroke>& outline) {
  marks.emplace_back(DiscMark{centre, radius, fill, outline});
}

void Drawing::band(const std::vector<Point>& first, const std::vector<Point>& second, Fill fill) {
  marks.emplace_back(BandMark{first, second, fill});
}

void Drawing::text(Point at, const std::string& text, TextStyle style) {
  if (!text.empty()) marks.emplace_back(TextMark{at, text, style});
}

void Drawing::clip(const std::vector<Point>& corners) { marks.emplace_back(ClipMark{corners}); }

void Drawing::clip(const Box& box) {
  clip({{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}});
}

void Drawing::end_clip() { marks.emplace_back(ClipMark{}); }

Drawing themed(Drawing drawing, Ground ground) {
  const auto change = [ground](Colour& colour) { colour = themed(colour, ground); };
  const auto change_both = [&](auto& mark) {
    if (mark.fill) change(mark.fill->colour);
    if (mark.outline) change(mark.outline->colour);
  };
  for (Mark& mark : drawing.marks) {
    if (auto* line = std::get_if<LineMark>(&mark)) change(line->stroke.colour);
    if (auto* polygon = std::get_if<PolygonMark>(&mark)) change_both(*polygon);
    if (auto* text = std::get_if<TextMark>(&mark)) change(text->style.colour);
    if (auto* band = std::get_if<BandMark>(&mark)) change(band->fill.colour);
    if (auto* disc = std::get_if<DiscMark>(&mark)) {
      change(disc->fill.colour);
      if (disc->outline) change(disc->outline->colour);
    }
  }
  change(drawing.ground);
  return drawing;
}

double text_width(const std::string& text, double size, bool bold) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()), cairo_destroy);
  use_font(context.get(), size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), text.c_str(), &extents);
  return extents.x_advance;
}

double baseline_shift(Side along) {
  switch (along) {
    case Side::low:
      return 0;
    case Side::middle:
      return capital_height / 2;
    case Side::high:
      return capital_height;
  }
  return 0;
}

std::vector<std::vector<Point>> dashed(const std::vector<Point>& line, const std::vector<double>& dashes) {
  if (dashes.empty() || line.size() < 2) return {line};
  std::vector<std::vector<Point>> pieces = {{line.front()}};
  std::size_t dash = 0;
  double left = dashes.front();  // of the current dash or gap
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point from = line[i];
    const Point to = line[i + 1];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    double walked = 0;
    while (length - walked > left) {
      walked += left;
      const Point here = {from.x + (to.x - from.x) * walked / length, from.y + (to.y - from.y) * walked / length};
      const bool drawing = dash % 2 == 0;
      if (drawing) {
        pieces.back().push_back(here);
      } else {
        pieces.push_back({here});
      }
      left = dashes[++dash % dashes.size()];
    }
    left -= length - walked;
    if (dash % 2 == 0) pieces.back().push_back(to);
  }
  return pieces;
}

}  // namespace packstone::viz
