#include "viz/composition.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace packstone::viz {

namespace {

/// A row of samples: of each the nearer of sphere and wall.
void compose_row(const PixelLayer& spheres, const WallLayer* walls, int row, std::uint32_t* samples) {
  const int width = spheres.window().width;
  if (!walls) {
    std::copy_n(spheres.colours(row), width, samples);
    return;
  }
  const auto [wall, wall_distance] = walls->row(row);
  if (spheres.blank()) {
    std::copy_n(wall, width, samples);
    return;
  }
  const std::uint32_t* const sphere = spheres.colours(row);
  const float* const distance = spheres.distances(row);
  for (int k = 0; k < width; ++k) samples[k] = wall_distance[k] < distance[k] ? wall[k] : sphere[k];
}

}  // namespace

Layer compose(const PixelLayer& spheres, const WallLayer* walls, int supersampling) {
  const PixelWindow& window = spheres.window();
  if (spheres.blank() && !walls) {
    const int width = window.width / supersampling, height = window.height / supersampling;
    return {width, height, std::vector<std::uint8_t>(window.pixels() / (supersampling * supersampling) * 4)};
  }
  std::vector<std::uint32_t> samples(window.pixels());
  for (int row = 0; row < window.height; ++row) {
    compose_row(spheres, walls, row, &samples[static_cast<std::size_t>(row) * window.width]);
  }
  return average_down(reinterpret_cast<const std::uint8_t*>(samples.data()), window.width, window.height,
                      supersampling);
}

}  // namespace packstone::viz
