// Drawings as files: PNG, SVG or PDF by the name's ending.
#pragma once

#include <filesystem>
#include <string>

#include "viz/drawing.hpp"
#include "viz/png.hpp"

namespace packstone::viz {

/// The bytes of an .svg or .pdf file. Throws InputError for any other ending.
std::string vector_file(const std::string& ending, const Drawing& drawing, const std::string& title);

/// Writes .png (with the text chunks), .svg or .pdf (with the title), whole or not at all.
/// Throws InputError for any other ending, RunError when the disk refuses.
void save_drawing(const std::filesystem::path& path, const Drawing& drawing, int supersampling,
                  const std::string& title, const PngText& text = {});

}  // namespace packstone::viz
