#include "viz/cairo_marks.hpp"

#include <cmath>

#include <cairo/cairo.h>

#include "viz/font.hpp"

namespace packstone::viz {

namespace {

class CairoMarks {
 public:
  explicit CairoMarks(cairo_t* context) : context_(context) { cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND); }

  void operator()(const LineMark& mark) {
    trace(mark.points);
    draw(std::nullopt, mark.stroke);
  }

  void operator()(const PolygonMark& mark) {
    trace(mark.corners);
    cairo_close_path(context_);
    draw(mark.fill, mark.outline);
  }

  void operator()(const DiscMark& mark) {
    cairo_new_sub_path(context_);
    cairo_arc(context_, mark.centre.x, mark.centre.y, mark.radius, 0, 2 * M_PI);
    cairo_close_path(context_);
    draw(mark.fill, mark.outline);
  }

  void operator()(const BandMark& mark) {
    trace(mark.first);
    for (auto point = mark.second.rbegin(); point != mark.second.rend(); ++point) {
      cairo_line_to(context_, point->x, point->y);
    }
    cairo_close_path(context_);
    draw(mark.fill, std::nullopt);
  }

  void operator()(const TextMark& mark) {
    const TextStyle& style = mark.style;
    use_font(context_, style.size, style.bold);
    cairo_text_extents_t extents;
    cairo_text_extents(context_, mark.text.c_str(), &extents);
    constexpr double share_before[] = {0, 0.5, 1};
    cairo_save(context_);
    cairo_translate(context_, mark.at.x, mark.at.y);
    if (style.upward) cairo_rotate(context_, -M_PI / 2);
    cairo_move_to(context_, -share_before[static_cast<int>(style.across)] * extents.x_advance,
                  baseline_shift(style.along) * style.size);
    set_colour(style.colour, 1);
    cairo_show_text(context_, mark.text.c_str());
    cairo_restore(context_);
    cairo_new_path(context_);
  }

  void operator()(const ClipMark& mark) {
    cairo_reset_clip(context_);
    if (mark.corners.empty()) return;
    trace(mark.corners);
    cairo_close_path(context_);
    cairo_clip(context_);
  }

 private:
  void trace(const std::vector<Point>& points) {
    for (const Point& p : points) cairo_line_to(context_, p.x, p.y);  // the first begins the path
  }

  void set_colour(Colour c, double opacity) {
    constexpr double full = 255;
    cairo_set_source_rgba(context_, c.r / full, c.g / full, c.b / full, opacity);
  }

  /// The path traced.
  void draw(const std::optional<Fill>& fill, const std::optional<Stroke>& stroke) {
    if (fill) {
      set_colour(fill->colour, fill->opacity);
      cairo_fill_preserve(context_);
    }
    if (stroke) {
      set_colour(stroke->colour, 1);
      cairo_set_line_width(context_, stroke->width);
      cairo_set_dash(context_, stroke->dashes.data(), static_cast<int>(stroke->dashes.size()), 0);
      cairo_stroke_preserve(context_);
    }
    cairo_new_path(context_);
  }

  cairo_t* context_;
};

}  // namespace

void draw_marks(cairo_t* context, const Drawing& drawing) {
  CairoMarks marks(context);
  for (const Mark& mark : drawing.marks) std::visit(marks, mark);
}

}  // namespace packstone::viz
