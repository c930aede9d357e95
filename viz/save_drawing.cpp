#include "viz/save_drawing.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "viz/drawing_painter.hpp"
#include "viz/pdf.hpp"
#include "viz/svg.hpp"

namespace packstone::viz {

std::string vector_file(const std::string& ending, const Drawing& drawing, const std::string& title) {
  if (ending == ".svg") return svg_text(drawing, title);
  if (ending == ".pdf") return pdf_bytes(drawing, title);
  throw InputError(fmt::format("{}: the ending is none of .png, .svg and .pdf", ending));
}

void save_drawing(const std::filesystem::path& path, const Drawing& drawing, int supersampling,
                  const std::string& title, const PngText& text) {
  const std::string ending = path.extension().string();
  if (ending == ".png") {
    const auto& paper_size = drawing.paper_size;
    write_png(path, draw_image(drawing, supersampling), text,
              paper_size ? std::optional(paper_size->dots_per_inch) : std::nullopt);
  } else {
    write_text_file(path, vector_file(ending, drawing, title));
  }
}

}  // namespace packstone::viz
