// The typeface of all pictures.
#pragma once

typedef struct _cairo cairo_t;

namespace packstone::viz {

/// Names for SVG and HTML, the first being the one whose widths text_width measures.
inline constexpr const char* font_names = "DejaVu Sans, Verdana, Arial, sans-serif";

/// Share of the font size that capitals and figures are high.
inline constexpr double capital_height = 0.73;

/// Sets DejaVu Sans, which has the signs physics needs, or what fontconfig takes for it where it is not installed; its
/// letters keep their shapes and widths whatever the pixels.
void use_font(cairo_t* context, double size, bool bold);

}  // namespace packstone::viz
