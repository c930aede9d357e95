// What drew a picture, told by the worker that did: only there is there an OpenGL context.
#pragma once

#include <algorithm>
#include <string>

#include "viz/offscreen.hpp"
#include "viz/png.hpp"
#include "viz/workers.hpp"

namespace packstone::cli {

/// Behind what was drawn, in a unit's result.
inline constexpr std::size_t drawn_by_bytes = 160;

inline void tell_drawn_by(viz::UnitResult& result) {
  const std::string renderer = viz::renderer_in_use();
  const std::size_t drawn = result.size();
  result.reserve(drawn + drawn_by_bytes);  // no more: pictures are large
  result.insert(result.end(), renderer.begin(), renderer.begin() + std::min(renderer.size(), drawn_by_bytes - 1));
  result.resize(drawn + drawn_by_bytes, 0);
}

/// Takes it off again.
inline std::string take_drawn_by(viz::UnitResult& result) {
  const std::size_t drawn = result.size() - drawn_by_bytes;
  const std::string renderer = reinterpret_cast<const char*>(result.data() + drawn);
  result.resize(drawn);
  return renderer;
}

/// The PNG's text chunks with it; as they are where nothing was drawn by OpenGL.
inline viz::PngText with_renderer(viz::PngText text, const std::string& renderer) {
  if (!renderer.empty()) text.emplace_back("Renderer", renderer);
  return text;
}

}  // namespace packstone::cli
