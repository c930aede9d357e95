#include "viz/drawing_painter.hpp"

#include <algorithm>
#include <utility>

#include <cairo/cairo.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "viz/cairo_marks.hpp"

namespace packstone::viz {

namespace {

void check_size(int width, int height) {
  if (std::min(width, height) >= 1 && std::max(width, height) <= max_drawing_side) return;
  throw InputError(fmt::format("cannot draw {} x {} px (with its super-sampling); a side takes 1 to {} px", width,
                               height, max_drawing_side));
}

}  // namespace

Layer DrawingPainter::paint(const Drawing& drawing, int supersampling) {
  return paint(drawing, {0, 0, drawing.width, drawing.height}, supersampling);
}

Layer DrawingPainter::paint(const Drawing& drawing, const PixelWindow& window, int supersampling) {
  const int width = window.width * supersampling, height = window.height * supersampling;
  check_size(width, height);
  constexpr int pixel_bytes = 4;
  pixels_.assign(static_cast<std::size_t>(width) * height * pixel_bytes, 0);
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_for_data(pixels_.data(), CAIRO_FORMAT_ARGB32, width, height, width * pixel_bytes),
      cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()), cairo_destroy);
  // By whole samples, so that Cairo's fixed-point coordinates round as in the whole drawing.
  cairo_translate(context.get(), -window.left * supersampling, -window.top * supersampling);
  cairo_scale(context.get(), supersampling, supersampling);
  draw_marks(context.get(), drawing);
  const cairo_status_t status = cairo_status(context.get());
  if (status != CAIRO_STATUS_SUCCESS) throw RunError(fmt::format("no drawing: {}", cairo_status_to_string(status)));
  cairo_surface_flush(surface.get());
  Layer layer = average_down(pixels_.data(), width, height, supersampling);
  // Cairo has blue first.
  for (std::size_t i = 0; i < layer.rgba.size(); i += pixel_bytes) std::swap(layer.rgba[i], layer.rgba[i + 2]);
  return layer;
}

Image draw_image(const Drawing& drawing, int supersampling) {
  const Layer layer = DrawingPainter().paint(drawing, supersampling);
  return flatten({&layer}, drawing.ground);
}

}  // namespace packstone::viz
