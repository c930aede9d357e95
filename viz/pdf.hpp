// A drawing as PDF: circles stay circles, text stays text in a font that is embedded.
#pragma once

#include <string>

#include "viz/drawing.hpp"

namespace packstone::viz {

/// The bytes of a PDF file of one page. The page has the drawing's paper size; without
/// one a pixel is a point (1/72 inch).
/// The same drawing gives the same bytes. Throws RunError when Cairo fails.
std::string pdf_bytes(const Drawing& drawing, const std::string& title);

}  // namespace packstone::viz
