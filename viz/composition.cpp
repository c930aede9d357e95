#include "viz/composition.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace packstone::viz {

namespace {

/// A row of samples: of each the nearer of body and wall. room holds it where it is neither's own.
const std::uint32_t* compose_row(const PixelLayer& bodies, const WallLayer* walls, int row,
                                 std::vector<std::uint32_t>& room) {
  if (!walls) return bodies.colours(row);
  const auto [wall, wall_distance] = walls->row(row);
  if (bodies.blank()) return wall;
  const std::uint32_t* const body = bodies.colours(row);
  const float* const distance = bodies.distances(row);
  for (std::size_t k = 0; k < room.size(); ++k) room[k] = wall_distance[k] < distance[k] ? wall[k] : body[k];
  return room.data();
}

}  // namespace

void compose(const PixelLayer& bodies, const WallLayer* walls, int supersampling, Layer& layer) {
  const PixelWindow& window = bodies.window();
  layer.width = window.width / supersampling;
  layer.height = window.height / supersampling;
  const std::size_t row_bytes = static_cast<std::size_t>(layer.width) * 4;
  layer.rgba.resize(row_bytes * static_cast<std::size_t>(layer.height));
  if (bodies.blank() && !walls) {
    std::fill(layer.rgba.begin(), layer.rgba.end(), 0);
    return;
  }
  std::vector<std::uint32_t> room(static_cast<std::size_t>(window.width));
  RowAverage average(window.width, supersampling);
  for (int row = 0; row < window.height; ++row) {
    const std::uint32_t* const samples = compose_row(bodies, walls, row, room);
    average.add(reinterpret_cast<const std::uint8_t*>(samples), &layer.rgba[row_bytes * (row / supersampling)]);
  }
}

}  // namespace packstone::viz
