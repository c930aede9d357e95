// A drawing as PDF: circles stay circles, text stays text in a font that is embedded.
#pragma once

#include <string>

#include "viz/drawing.hpp"

namespace packstone::viz {

/// The bytes of a PDF file of one page on white paper. A pixel of the drawing is a point (1/72 inch) of the page.
/// The same drawing gives the same bytes. Throws RunError when Cairo fails.
std::string pdf_bytes(const Drawing& drawing, const std::string& title);

}  // namespace packstone::viz
