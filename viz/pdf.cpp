#include "viz/pdf.hpp"

#include <memory>

#include <cairo/cairo-pdf.h>
#include <cairo/cairo.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/version.hpp"
#include "viz/cairo_marks.hpp"

namespace packstone::viz {

namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int count) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string pdf_bytes(const Drawing& drawing, const std::string& title) {
  constexpr double points_per_millimetre = 72 / 25.4;
  double width = drawing.width, height = drawing.height;
  if (drawing.paper_size) {
    width = drawing.paper_size->width_mm * points_per_millimetre;
    height = drawing.paper_size->height_mm * points_per_millimetre;
  }
  std::string bytes;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_pdf_surface_create_for_stream(append, &bytes, width, height), cairo_surface_destroy);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR,
                                 fmt::format("packstone {}", version()).c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // else two runs would differ
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()), cairo_destroy);
  cairo_scale(context.get(), width / drawing.width, height / drawing.height);
  constexpr double full = 255;
  const Colour& ground = drawing.ground;
  cairo_set_source_rgb(context.get(), ground.r / full, ground.g / full, ground.b / full);
  cairo_paint(context.get());
  draw_marks(context.get(), drawing);
  const cairo_status_t drawn = cairo_status(context.get());
  cairo_surface_finish(surface.get());
  const cairo_status_t written = cairo_surface_status(surface.get());
  const cairo_status_t status = drawn != CAIRO_STATUS_SUCCESS ? drawn : written;
  if (status != CAIRO_STATUS_SUCCESS) throw RunError(fmt::format("no PDF: {}", cairo_status_to_string(status)));
  return bytes;
}

}  // namespace packstone::viz
