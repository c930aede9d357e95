// What drew a picture, told by the worker that did: only there is there an OpenGL context.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "viz/offscreen.hpp"
#include "viz/png.hpp"

namespace packstone::cli {

/// Behind the pixels of a unit's result.
inline constexpr std::size_t drawn_by_bytes = 160;

inline void tell_drawn_by(std::uint8_t* end_of_pixels) {
  const std::string renderer = viz::renderer_in_use();
  std::memcpy(end_of_pixels, renderer.data(), std::min(renderer.size(), drawn_by_bytes - 1));
}

inline std::string drawn_by(const std::uint8_t* end_of_pixels) { return reinterpret_cast<const char*>(end_of_pixels); }

/// The PNG's text chunks with it; as they are where nothing was drawn by OpenGL.
inline viz::PngText with_renderer(viz::PngText text, const std::string& renderer) {
  if (!renderer.empty()) text.emplace_back("Renderer", renderer);
  return text;
}

}  // namespace packstone::cli
