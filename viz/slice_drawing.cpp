#include "viz/slice_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "viz/boundary_cut.hpp"
#include "viz/common_colouring.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/font.hpp"
#include "viz/legend.hpp"
#include "viz/panels.hpp"
#include "viz/plot_frame.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

namespace {

// All as multiples of the font size.
constexpr double column_gap = 2.0;
constexpr double title_room = 2.2;
constexpr double title_size = 1.15;
constexpr double line_height = 1.8;
constexpr double panel_gap = 1.0;
constexpr double panel_title_room = 1.6;
constexpr double scale_bar_room = 7;
constexpr double outline_weight = 0.045;
constexpr double wall_weight = 0.14;

// Outlines of discs are no heavier than this share of their median radius, and none where that is thinner than so many
// pixels.
constexpr double heaviest_outline = 0.08;
constexpr double thinnest_outline = 0.15;

/// A panel's part of its plane.
struct Extent {
  std::vector<InPlane> corners;
  InPlane low, high;

  Extent(const Domain& domain, const SlicePlane& plane) : corners(section(domain, plane)) {
    if (corners.empty()) corners = {{0, 0}};  // slice_discs refuses it
    low = high = corners.front();
    for (const InPlane& p : corners) {
      low = {std::min(low.u, p.u), std::min(low.v, p.v)};
      high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    }
  }
  double width() const { return high.u - low.u; }
  double height() const { return high.v - low.v; }
};

/// Letters as small as a line of them must be to have room.
double fitting_size(const std::string& text, double size, double room, bool bold) {
  const double width = text_width(text, size, bold);
  return width > room ? size * room / width : size;
}

/// What the axes of a plane are called.
std::string axis_label(const SlicePlane& plane, bool across, const std::string& unit) {
  if (plane.axis) {
    const PlaneAxes axes = axes_in_plane(*plane.axis);
    return fmt::format("{} [{}]", axis_names[across ? axes.u : axes.v], unit);
  }
  const Vec3& way = across ? plane.right : plane.up;
  return fmt::format("along {} [{}]", vector_text(way, 2), unit);
}

/// All that stands beside the panels, from the top: what the colours mean, plane and time where they are common, a
/// scale bar.
class SideColumn {
 public:
  SideColumn(const std::vector<SlicePanel>& panels, const SliceOptions& options, ColourKey key, double font)
      : key_(std::move(key)), font_(font), legend_(options.legend && !key_.empty()) {
    const auto all = [&](auto&& same) { return std::all_of(panels.begin(), panels.end(), same); };
    const SlicePanel& first = panels.front();
    const std::string plane = plane_text(first.plane);
    if (all([&](const SlicePanel& p) { return plane_text(p.plane) == plane; })) add_plane(first.plane);
    const double time = first.particles.snapshot->time;
    if (options.time && all([&](const SlicePanel& p) { return p.particles.snapshot->time == time; })) {
      lines_.push_back(time_text(time));
      tells_time_ = true;
    }
  }

  /// That of all panels.
  bool tells_time() const { return tells_time_; }

  double width() const {
    double width = std::max(scale_bar_room * font_, text_width("t = 0000.000 ms", font_));
    for (const std::string& line : lines_) width = std::max(width, text_width(line, font_));
    return legend_ ? std::max(width, legend_width(key_, font_)) : width;
  }

  void draw(Drawing& drawing, const Box& box, double metres_per_pixel) const {
    double y = box.bottom;
    draw_scale_bar(drawing, {box.left, y}, metres_per_pixel, scale_bar_room * font_, font_);
    y -= 2 * line_height * font_;
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) {
      drawing.text({box.left, y}, *line, {.size = font_});
      y -= line_height * font_;
    }
    Box room = box;
    room.bottom = y - (capital_height - line_height / 2) * font_;
    if (legend_) draw_legend(drawing, room, key_, font_);
  }

 private:
  void add_plane(const SlicePlane& plane) {
    if (!plane.axis) lines_.push_back(through_text(plane));
    lines_.push_back(plane.axis ? plane_text(plane) : normal_text(plane));
  }

  ColourKey key_;
  double font_;
  bool legend_;
  bool tells_time_ = false;
  std::vector<std::string> lines_;
};

/// The panels' places: the largest of one scale that fit, in the middle together with the column.
struct SliceLayout {
  std::vector<PlotFrame> frames;
  double metres_per_pixel = 0;
  Box column;
  std::vector<double> heading_room;  ///< of each panel, from its left [px]
};

PlotFrame axes_of(const SlicePanel& panel, const Extent& extent, double unit, const std::string& unit_name,
                  double font) {
  PlotFrame frame;
  frame.font = font;
  frame.x = {extent.low.u / unit, extent.high.u / unit, false};
  frame.y = {extent.low.v / unit, extent.high.v / unit, false};
  frame.x_label = axis_label(panel.plane, true, unit_name);
  frame.y_label = axis_label(panel.plane, false, unit_name);
  return frame;
}

SliceLayout lay_out_panels(const std::vector<SlicePanel>& panels, const std::vector<Extent>& extents,
                           const SliceOptions& options, double column, double font) {
  const int columns = panel_columns(options.columns, panels.size());
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const double edge = options.margin * font, gap = panel_gap * font;
  const double top = edge + (options.title.empty() ? 0 : title_room * font);
  const double over = panels.size() > 1 ? panel_title_room * font : 0;
  const double cell_width = (options.width - 2 * edge - column - column_gap * font - gap * (columns - 1)) / columns;
  const double cell_height = (options.height - edge - top - gap * (rows - 1)) / rows;
  double width = 0, height = 0;  // of the largest [m]
  for (const Extent& extent : extents) {
    width = std::max(width, extent.width());
    height = std::max(height, extent.height());
  }
  const ReadableUnit unit = length_unit(std::max(width, height));
  SliceLayout layout;
  double before = 0;  // room left of a panel
  for (std::size_t k = 0; k < panels.size(); ++k) {
    PlotFrame frame = axes_of(panels[k], extents[k], unit.scale, unit.name, font);
    before = std::max(before, left_room(frame.y, cell_height - lower_room(font) - over, font));
    layout.frames.push_back(std::move(frame));
  }
  const double pixels_per_metre =
      std::min((cell_width - before) / width, (cell_height - over - lower_room(font)) / height);
  if (!(pixels_per_metre > 0)) {
    throw InputError(fmt::format("a slice of {} x {} px has no room beside its labels", options.width, options.height));
  }
  layout.metres_per_pixel = 1 / pixels_per_metre;
  const double used_width = before + width * pixels_per_metre, used_height = over + height * pixels_per_metre;
  const double all_width = columns * used_width + (columns - 1) * gap;
  const double room = options.width - 2 * edge - column - column_gap * font;
  const double start = edge + (room - all_width) / 2;
  const double all_height = rows * (used_height + lower_room(font)) + (rows - 1) * gap;
  const double upper = top + (options.height - edge - top - all_height) / 2;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const int i = static_cast<int>(k) % columns, j = static_cast<int>(k) / columns;
    const double left = start + i * (used_width + gap) + before;
    const double bottom = upper + j * (used_height + lower_room(font) + gap) + used_height;
    layout.frames[k].box = {left, bottom - extents[k].height() * pixels_per_metre,
                            left + extents[k].width() * pixels_per_metre, bottom};
    const bool last = i == columns - 1 || k + 1 == panels.size();
    layout.heading_room.push_back(last ? options.width - edge - left : used_width);
  }
  const double left = start + all_width + column_gap * font;
  const double lowest = upper + (rows - 1) * (used_height + lower_room(font) + gap) + used_height;
  layout.column = {left, upper + over, left + column, lowest};
  return layout;
}

double outline_width(const std::vector<Disc>& discs, double metres_per_pixel, double font) {
  if (discs.empty()) return 0;
  std::vector<double> radii;
  for (const Disc& disc : discs) radii.push_back(disc.radius / metres_per_pixel);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  const double width = std::min(outline_weight * font, heaviest_outline * *middle);
  return width < thinnest_outline ? 0 : width;
}

void draw_panel(Drawing& drawing, const SlicePanel& panel, const Extent& extent, const PlotFrame& frame,
                const Colouring& colouring, double metres_per_pixel) {
  const std::vector<Disc> discs = slice_discs(panel.particles, panel.plane);
  const auto pixel = [&](const InPlane& p) {
    return Point{frame.box.left + (p.u - extent.low.u) / metres_per_pixel,
                 frame.box.bottom - (p.v - extent.low.v) / metres_per_pixel};
  };
  std::vector<Point> outline;
  for (const InPlane& p : extent.corners) outline.push_back(pixel(p));
  if (panel.plane.axis) {
    drawing.clip(frame.box);
  } else {
    drawing.clip(outline);
  }
  for (const CutLine& line : boundary_cut(*panel.particles.snapshot, panel.plane)) {
    std::vector<Point> points;
    for (const InPlane& p : line) points.push_back(pixel(p));
    if (line.front() == line.back()) points.push_back(points[1]);  // so that the ends meet in a corner
    drawing.polyline(points, Stroke{wall_edge, wall_weight * frame.font, {}});
  }
  const double width = outline_width(discs, metres_per_pixel, frame.font);
  const auto edge = width > 0 ? std::optional(Stroke{ink, width, {}}) : std::nullopt;
  for (const Disc& disc : discs) {
    drawing.disc(pixel({disc.u, disc.v}), disc.radius / metres_per_pixel, Fill{colouring.colours[disc.row]}, edge);
  }
  drawing.end_clip();
  if (!panel.plane.axis) drawing.polygon(outline, std::nullopt, Stroke{wall_edge, outline_weight * frame.font, {}});
  draw_axes(drawing, frame);
}

}  // namespace

Drawing slice_drawing(const std::vector<SlicePanel>& panels, const SliceOptions& options) {
  const double font = font_size(options.width, options.height) * options.font_scale;
  std::vector<Extent> extents;
  std::vector<ParticleView> packings;
  for (const SlicePanel& panel : panels) {
    extents.emplace_back(panel.particles.snapshot->domain, panel.plane);
    packings.push_back(panel.particles);
  }
  const std::vector<Colouring> colourings = colour_together(packings, options.color, options.range);
  const SideColumn column(panels, options, colourings.front(), font);
  const SliceLayout layout = lay_out_panels(panels, extents, options, column.width(), font);
  Drawing drawing{options.width, options.height, {}};
  drawing.text({options.width / 2.0, options.margin * font}, options.title,
               {.size = fitting_size(options.title, title_size * font, options.width - 2 * options.margin * font, true),
                .across = Side::middle,
                .along = Side::high,
                .bold = true});
  for (std::size_t k = 0; k < panels.size(); ++k) {
    draw_panel(drawing, panels[k], extents[k], layout.frames[k], colourings[k], layout.metres_per_pixel);
    if (panels.size() == 1) continue;
    constexpr double above = 0.6;
    const Box& box = layout.frames[k].box;
    std::string heading = lettered(k, panels[k].title);
    if (options.time && !column.tells_time()) heading += ", " + time_text(panels[k].particles.snapshot->time);
    drawing.text({box.left, box.top - above * font}, heading,
                 {.size = fitting_size(heading, font, layout.heading_room[k], false)});
  }
  column.draw(drawing, layout.column, layout.metres_per_pixel);
  return drawing;
}

Drawing slice_drawing(const ParticleView& particles, const SlicePlane& plane, const SliceOptions& options) {
  return slice_drawing({SlicePanel{particles, plane, ""}}, options);
}

Image draw_slice(const ParticleView& particles, const SlicePlane& plane, const SliceOptions& options) {
  return draw_image(slice_drawing(particles, plane, options), options.supersampling);
}

}  // namespace packstone::viz
