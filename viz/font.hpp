// The typeface of all pictures.
#pragma once

class vtkTextProperty;

namespace packstone::viz {

inline constexpr const char* font_name = "DejaVu Sans";

/// Names for SVG and HTML, the first being the one whose widths text_width measures.
inline constexpr const char* font_names = "DejaVu Sans, Verdana, Arial, sans-serif";

/// Share of the font size that capitals and figures are high.
inline constexpr double capital_height = 0.73;

/// Sets DejaVu Sans, which has the signs physics needs; VTK's own typeface, which lacks most, where it is not
/// installed.
void use_font(vtkTextProperty* property, bool bold);

}  // namespace packstone::viz
