// A drawing as SVG: circles stay circles, text stays text.
#pragma once

#include <string>

#include "viz/drawing.hpp"

namespace packstone::viz {

/// The text of an SVG 1.1 file.
std::string svg_text(const Drawing& drawing, const std::string& title);

/// Text for HTML and XML: & < > and quotes become entities; characters XML does not know are dropped.
std::string escaped(const std::string& text);

}  // namespace packstone::viz
