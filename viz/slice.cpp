#include "viz/slice.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "viz/boundary_cut.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/font.hpp"
#include "viz/legend.hpp"
#include "viz/plot_frame.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

namespace {

/// The shifts of one particle along an axis that may bring it to where it is seen: itself and its nearest images.
std::vector<double> shifts(const Domain& domain, int axis) {
  if (!domain.periodic[axis]) return {0};
  const double length = domain.max[axis] - domain.min[axis];
  return {-length, 0, length};
}

/// True when a disc reaches into the domain's rectangle.
bool reaches_in(const Disc& disc, const Domain& domain, PlaneAxes axes) {
  const double u = std::clamp(disc.u, domain.min[axes.u], domain.max[axes.u]);
  const double v = std::clamp(disc.v, domain.min[axes.v], domain.max[axes.v]);
  return std::hypot(disc.u - u, disc.v - v) < disc.radius;
}

// All as multiples of the font size.
constexpr double column_gap = 2.0;
constexpr double title_room = 2.2;
constexpr double title_size = 1.15;
constexpr double line_height = 1.8;
constexpr double scale_bar_room = 7;
constexpr double outline_weight = 0.045;
constexpr double wall_weight = 0.14;

std::string plane_text(const SlicePlane& plane) {
  return fmt::format("{} = {}", axis_names[plane.axis], length_text(plane.position));
}

double column_width(const SliceOptions& options, const SlicePlane& plane, const Colouring& colouring, double font) {
  double width = std::max(text_width(plane_text(plane), font), scale_bar_room * font);
  if (options.legend) width = std::max(width, legend_width(colouring, font));
  if (options.time) width = std::max(width, text_width("t = 0000.000 ms", font));
  return width;
}

AxisScale axis_scale(const Domain& domain, int axis, double unit) {
  return {domain.min[axis] / unit, domain.max[axis] / unit, false};
}

/// The largest frame of the domain's proportions that fits, in the middle of the picture together with the column.
PlotFrame lay_out(const Snapshot& snapshot, PlaneAxes axes, const SliceOptions& options, double column) {
  const double font = font_size(options.width, options.height) * options.font_scale;
  const Domain& domain = snapshot.domain;
  const Vec3 size = domain.size();
  const ReadableUnit unit = length_unit(std::max(size[axes.u], size[axes.v]));
  PlotFrame frame;
  frame.font = font;
  frame.x = axis_scale(domain, axes.u, unit.scale);
  frame.y = axis_scale(domain, axes.v, unit.scale);
  frame.x_label = fmt::format("{} [{}]", axis_names[axes.u], unit.name);
  frame.y_label = fmt::format("{} [{}]", axis_names[axes.v], unit.name);
  const double top = (options.margin + (options.title.empty() ? 0 : title_room)) * font;
  const double bottom = options.height - options.margin * font - lower_room(font);
  const double left = options.margin * font + left_room(frame.y, bottom - top, font);
  const double right = options.width - options.margin * font - column - column_gap * font;
  const double pixels_per_metre = std::min((right - left) / size[axes.u], (bottom - top) / size[axes.v]);
  if (pixels_per_metre <= 0) {
    throw InputError(fmt::format("a slice of {} x {} px has no room beside its labels", options.width, options.height));
  }
  const double width = size[axes.u] * pixels_per_metre;
  const double height = size[axes.v] * pixels_per_metre;
  const double start = left + (right - left - width) / 2;
  const double upper = top + (bottom - top - height) / 2;
  frame.box = {start, upper, start + width, upper + height};
  return frame;
}

}  // namespace

SlicePlane plane_from_text(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t name = text.find_first_not_of(' ');
  for (int axis = 0; axis < 3; ++axis) {
    if (equals == std::string::npos || text.substr(name, equals - name).find(axis_names[axis]) != 0) continue;
    if (text.find_first_not_of(' ', name + 1) != equals) continue;
    const std::size_t value = text.find_first_not_of(' ', equals + 1);
    if (value == std::string::npos) continue;
    return {axis, parse_quantity(text.substr(value), unit::metre)};
  }
  throw InputError(fmt::format("'{}' is not a plane; 'z=0.1' or 'y=290 mm' would be", text));
}

PlaneAxes axes_in_plane(int axis) {
  constexpr PlaneAxes axes[] = {{1, 2}, {0, 2}, {0, 1}};
  return axes[axis];
}

std::vector<Disc> slice_discs(const Snapshot& snapshot, const SlicePlane& plane) {
  const Domain& domain = snapshot.domain;
  if (!(plane.position >= domain.min[plane.axis] && plane.position <= domain.max[plane.axis])) {
    throw InputError(fmt::format("the plane {} misses the domain, which spans {} to {}", plane_text(plane),
                                 length_text(domain.min[plane.axis]), length_text(domain.max[plane.axis])));
  }
  const PlaneAxes axes = axes_in_plane(plane.axis);
  const std::vector<double> along = shifts(domain, plane.axis);
  const std::vector<double> across_u = shifts(domain, axes.u);
  const std::vector<double> across_v = shifts(domain, axes.v);
  std::vector<Disc> discs;
  for (std::size_t row = 0; row < snapshot.size(); ++row) {
    const Vec3& p = snapshot.position[row];
    const double r = snapshot.radius[row];
    for (const double shift : along) {
      const double h = p[plane.axis] + shift - plane.position;
      if (std::abs(h) >= r) continue;
      const double radius = std::sqrt(r * r - h * h);
      for (const double du : across_u) {
        for (const double dv : across_v) {
          const Disc disc{p[axes.u] + du, p[axes.v] + dv, radius, row};
          if (reaches_in(disc, domain, axes)) discs.push_back(disc);
        }
      }
    }
  }
  return discs;
}

Drawing slice_drawing(const Snapshot& snapshot, const SlicePlane& plane, const SliceOptions& options) {
  const std::vector<Disc> discs = slice_discs(snapshot, plane);
  const Colouring colouring = colour_particles(snapshot, options.color, options.range);
  const PlaneAxes axes = axes_in_plane(plane.axis);
  const double font = font_size(options.width, options.height) * options.font_scale;
  const double column = column_width(options, plane, colouring, font);
  const PlotFrame frame = lay_out(snapshot, axes, options, column);
  const double metres_per_pixel = snapshot.domain.size()[axes.u] / frame.box.width();
  Drawing drawing{options.width, options.height, {}};
  drawing.text({options.width / 2.0, options.margin * font}, options.title,
               {.size = title_size * font, .across = Side::middle, .along = Side::high, .bold = true});
  const Vec3& origin = snapshot.domain.min;
  const auto pixel = [&](double u, double v) {
    return Point{frame.box.left + (u - origin[axes.u]) / metres_per_pixel,
                 frame.box.bottom - (v - origin[axes.v]) / metres_per_pixel};
  };
  drawing.clip(frame.box);
  for (const CutLine& line : boundary_cut(snapshot, plane)) {
    std::vector<Point> points;
    for (const auto& [u, v] : line) points.push_back(pixel(u, v));
    if (line.front() == line.back()) points.push_back(points[1]);  // so that the ends meet in a corner
    drawing.polyline(points, Stroke{wall_edge, wall_weight * font, {}});
  }
  for (const Disc& disc : discs) {
    drawing.disc(pixel(disc.u, disc.v), disc.radius / metres_per_pixel, Fill{colouring.colours[disc.row]},
                 Stroke{ink, outline_weight * font, {}});
  }
  drawing.clip(std::nullopt);
  draw_axes(drawing, frame);
  const double left = frame.box.right + column_gap * font;
  double y = frame.box.bottom;
  draw_scale_bar(drawing, {left, y}, metres_per_pixel, scale_bar_room * font, font);
  y -= 2 * line_height * font;
  if (options.time) {
    drawing.text({left, y}, time_text(snapshot.time), {.size = font});
    y -= line_height * font;
  }
  drawing.text({left, y}, plane_text(plane), {.size = font});
  if (options.legend) {
    const double lowest = y - (capital_height + line_height / 2) * font;
    draw_legend(drawing, {left, frame.box.top, left + column, lowest}, colouring, font);
  }
  return drawing;
}

Image draw_slice(const Snapshot& snapshot, const SlicePlane& plane, const SliceOptions& options) {
  return draw_image(slice_drawing(snapshot, plane, options), options.supersampling);
}

}  // namespace packstone::viz
