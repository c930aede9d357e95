#include "viz/annotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/font.hpp"
#include "viz/legend.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

namespace {

// All as multiples of the font size.
constexpr double margin = 1.2;
constexpr double column_gap = 2.0;
constexpr double title_size = 1.15;
constexpr double title_room = 2.2;
constexpr double label_gap = 0.7;
constexpr double scale_bar_room = 7;
constexpr double arrow_length = 1.9;
constexpr double arrow_head = 0.4;
constexpr double triad_room = 2.8;
constexpr double line_weight = 0.08;
constexpr double row_gap = 1.2;
constexpr double legend_gap = 1.6;
constexpr double lowest_column = 24;  ///< less would not take a colour bar and all that stands below

constexpr double sphere_room = 0.035;  ///< around the box, in unit space: particles reach out of periodic sides

// Times of any length of run have room, so that the layout does not move from frame to frame.
const std::string widest_time = "t = 0000.000 ms";

double column_width(const PictureOptions& options, const ColourKeys& keys, double font) {
  double width = 0;
  for (const ColourKey& key : keys) width = std::max(width, legend_width(key, font));
  if (options.time) width = std::max(width, text_width(widest_time, font));
  if (options.scale && !options.view.perspective()) width = std::max(width, scale_bar_room * font);
  if (options.axes) width = std::max(width, (triad_room + arrow_length) * font);
  return width;
}

/// The pixels that a box takes.
Box extent(const Camera& camera, const Vec3& min, const Vec3& max) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Box box{infinite, infinite, -infinite, -infinite};
  for (const Vec3& corner : box_corners(min, max)) {
    const Point p = camera.project(corner);
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
  }
  return box;
}

bool has_edge_lengths(const PictureOptions& options) {
  return options.scale && options.view.perspective() && !options.view.close();
}

/// Length of the domain's edge along an axis, as text.
std::string edge_text(const UnitSpace& space, int axis) {
  return length_text((space.max[axis] - space.min[axis]) / space.scale);
}

/// The middle of the one of the four edges along an axis that lies lowest in the picture, or for z farthest left.
Vec3 labelled_edge(const UnitSpace& space, const Camera& camera, int axis) {
  Vec3 best = Vec3::Zero();
  double best_rank = -std::numeric_limits<double>::infinity();
  for (const Vec3& corner : box_corners(space.min, space.max)) {
    Vec3 middle = corner;
    middle[axis] = (space.min[axis] + space.max[axis]) / 2;
    const Point p = camera.project(middle);
    const double rank = axis == 2 ? -p.x : p.y;
    if (rank > best_rank) {
      best_rank = rank;
      best = middle;
    }
  }
  return best;
}

void draw_edge_lengths(Drawing& drawing, const UnitSpace& space, const Layout& layout) {
  const Point middle = layout.camera.project(Vec3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    const Point at = layout.camera.project(labelled_edge(space, layout.camera, axis));
    const double gap = label_gap * layout.font;
    if (axis == 2) {
      drawing.text({at.x - gap, at.y}, edge_text(space, axis),
                   {.size = layout.font, .across = Side::high, .along = Side::middle});
    } else {
      const bool left = at.x < middle.x;
      drawing.text({at.x + (left ? -gap : gap) / 2, at.y + gap}, edge_text(space, axis),
                   {.size = layout.font, .across = left ? Side::high : Side::low, .along = Side::high});
    }
  }
}

void draw_arrow(Drawing& drawing, Point from, Point to, double font) {
  const Stroke stroke{ink, line_weight * font, {}};
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Point along = {(to.x - from.x) / length * arrow_head * font, (to.y - from.y) / length * arrow_head * font};
  const Point base = {to.x - along.x, to.y - along.y};
  drawing.line(from, base, stroke);
  constexpr double half_width = 0.4;  // of the head's length
  const Point side = {-along.y * half_width, along.x * half_width};
  drawing.polygon({to, {base.x + side.x, base.y + side.y}, {base.x - side.x, base.y - side.y}}, Fill{ink},
                  std::nullopt);
}

void draw_triad(Drawing& drawing, const Camera& camera, Point origin, double font) {
  constexpr double shortest = 0.1;  // an axis seen end on
  for (int axis = 0; axis < 3; ++axis) {
    const Point way = {camera.axes()[0][axis], -camera.axes()[1][axis]};
    const double length = std::hypot(way.x, way.y);
    if (length < shortest) continue;
    const double reach = arrow_length * font;
    draw_arrow(drawing, origin, {origin.x + way.x * reach, origin.y + way.y * reach}, font);
    const double beyond = reach + label_gap * font / length;
    drawing.text({origin.x + way.x * beyond, origin.y + way.y * beyond}, axis_names[axis],
                 {.size = font, .across = Side::middle, .along = Side::middle});
  }
}

void draw_time(Annotation& annotation, Point at, double time, double font) {
  constexpr double above = 1.2, below = 0.4, beside = 0.2;  // of the font's size
  const int left = static_cast<int>(at.x - beside * font), top = static_cast<int>(at.y - above * font);
  const int right = static_cast<int>(std::ceil(at.x + text_width(widest_time, font) + beside * font));
  const int bottom = static_cast<int>(std::ceil(at.y + below * font));
  const PixelWindow picture{0, 0, annotation.still.width, annotation.still.height};
  annotation.changing_in = picture.common({left, top, right - left, bottom - top});
  annotation.changing.text(at, time_text(time), {.size = font});
}

/// From the column's bottom up: directions, scale bar, time.
double draw_lower_column(Annotation& annotation, const PictureOptions& options, const UnitSpace& space,
                         const Layout& layout, double time) {
  Drawing& drawing = annotation.still;
  const double font = layout.font;
  double y = layout.column.bottom;
  if (options.axes) {
    // Room for arrows to either side of the origin, as views from behind and below have them.
    const auto& axes = layout.camera.axes();
    const double left = std::min({0.0, axes[0][0], axes[0][1], axes[0][2]});
    const double down = std::max({0.0, -axes[1][0], -axes[1][1], -axes[1][2]});
    const double up = std::max({0.0, axes[1][0], axes[1][1], axes[1][2]});
    const Point origin = {layout.column.left + label_gap * font - left * triad_room * font,
                          y - label_gap * font - down * triad_room * font};
    draw_triad(drawing, layout.camera, origin, font);
    y = origin.y - up * triad_room * font - row_gap * font;
  }
  if (options.scale && layout.camera.parallel()) {
    const double metres_per_pixel = 1 / (layout.camera.pixels_per_unit() * space.scale);
    draw_scale_bar(drawing, {layout.column.left, y}, metres_per_pixel, scale_bar_room * font, font);
    constexpr double scale_bar_height = 1.5;
    y -= (scale_bar_height + row_gap) * font;
  }
  if (options.time) {
    draw_time(annotation, {layout.column.left, y}, time, font);
    y -= (capital_height + row_gap) * font;
  }
  return y;
}

/// The box that just fits into the picture, in unit space.
struct Fitted {
  Vec3 min, max;

  Fitted(const PictureOptions& options, const UnitSpace& space) : min(space.min), max(space.max) {
    double room = sphere_room;
    if (options.fit) {
      const Vec3 size = *options.fit * space.scale;
      const Vec3 middle(0, 0, space.min.z() + size.z() / 2);
      min = middle - size / 2;
      max = middle + size / 2;
      room *= size.maxCoeff();
    }
    min.array() -= room;
    max.array() += room;
  }
};

/// Smaller where it would not fit.
void draw_title(Drawing& drawing, const std::string& title, double font) {
  const double usual = title_size * font, width = text_width(title, usual, true);
  const double size = usual * std::min(1.0, (drawing.width - 2 * margin * font) / std::max(width, 1.0));
  drawing.text({drawing.width / 2.0, margin * font}, title,
               {.size = size, .across = Side::middle, .along = Side::high, .bold = true});
}

/// The legends share the room, each a part of what is left.
void draw_legends(Drawing& drawing, Box room, const ColourKeys& keys, double font) {
  for (std::size_t k = 0; k < keys.size(); ++k) {
    Box area = room;
    area.bottom = room.top + room.height() / static_cast<double>(keys.size() - k);
    if (k + 1 < keys.size()) area.bottom -= legend_gap * font;
    room.top = draw_legend(drawing, area, keys[k], font) + legend_gap * font;
  }
}

}  // namespace

UnitSpace::UnitSpace(const Domain& domain)
    : centre((domain.min + domain.max) / 2),
      scale(1 / domain.size().maxCoeff()),
      min((domain.min - centre) * scale),
      max((domain.max - centre) * scale) {}

double room_beside(const PictureOptions& options, const UnitSpace& space, const ColourKeys& keys) {
  const double font = font_size(options.width, options.height) * options.font_scale;
  const double width = column_width(options, keys, font);
  if (width > 0) return width + column_gap * font;
  return has_edge_lengths(options) ? text_width(edge_text(space, 1), font) : 0;
}

Layout lay_out(const PictureOptions& options, const UnitSpace& space, const ColourKeys& keys) {
  const double font = font_size(options.width, options.height) * options.font_scale;
  const double edge = margin * font;
  const double column = column_width(options, keys, font);
  Box region{edge, edge, options.width - edge, options.height - edge};
  if (!options.title.empty()) region.top += title_room * font;
  region.right -= room_beside(options, space, keys);
  if (has_edge_lengths(options)) {
    region.left += text_width(edge_text(space, 2), font);
    region.bottom -= font;
  }
  const Fitted fitted(options, space);
  Camera camera(options.view, fitted.min, fitted.max, region);
  std::optional<PixelWindow> frame;
  if (options.view.close()) {
    std::optional<Vec3> focus = options.view.focus;
    if (focus) focus = (*focus - space.centre) * space.scale;
    camera.look_closer(options.view.zoom, focus);
    const int left = static_cast<int>(std::ceil(region.left)), top = static_cast<int>(std::ceil(region.top));
    frame = PixelWindow{left, top, static_cast<int>(region.right) - left, static_cast<int>(region.bottom) - top};
  }
  // Box and column stand together in the middle of the picture.
  const Box content = frame ? region : extent(camera, fitted.min, fitted.max);
  const double shift = (region.left + region.right - content.left - content.right) / 2;
  camera.move_right(shift);
  const double left = content.right + shift + (column > 0 ? column_gap * font : 0);
  const double missing = std::max(0.0, lowest_column * font - content.height());
  return {font,
          camera,
          {left, std::max(region.top, content.top - missing / 2), left + column,
           std::min(options.height - edge, content.bottom + missing / 2)},
          frame};
}

Annotation annotate(const PictureOptions& options, const UnitSpace& space, const Layout& layout, const ColourKeys& keys,
                    double time) {
  const Drawing empty{options.width, options.height, {}};
  Annotation annotation{empty, empty, {}};
  Drawing& drawing = annotation.still;
  draw_title(drawing, options.title, layout.font);
  if (has_edge_lengths(options)) draw_edge_lengths(drawing, space, layout);
  if (layout.frame) {
    const PixelWindow& frame = *layout.frame;
    drawing.rectangle({static_cast<double>(frame.left), static_cast<double>(frame.top),
                       static_cast<double>(frame.right()), static_cast<double>(frame.bottom())},
                      std::nullopt, Stroke{faint_ink, line_weight * layout.font, {}});
  }
  const double legend_bottom = draw_lower_column(annotation, options, space, layout, time);
  Box legends = layout.column;
  legends.bottom = legend_bottom;
  draw_legends(drawing, legends, keys, layout.font);
  annotation.still = themed(std::move(annotation.still), options.ground);
  annotation.changing = themed(std::move(annotation.changing), options.ground);
  return annotation;
}

}  // namespace packstone::viz
