#include "viz/composition.hpp"

#include <cstring>
#include <vector>

namespace packstone::viz {

namespace {

/// A row of samples, of the same layout as an image's rows.
void compose_row(const SphereLayer& spheres, const WallLayer* walls, int row, std::uint32_t* samples) {
  const int width = spheres.window().width;
  std::copy_n(spheres.colours(row), width, samples);
  if (!walls) return;
  const auto [rgba, depth] = walls->row(row);
  const float* const distance = spheres.distances(row);
  constexpr int alpha = 3;
  for (int k = 0; k < width; ++k) {
    const std::uint8_t* const wall = &rgba[4 * k];
    if (wall[alpha] == 0 || walls->distance(depth[k]) >= distance[k]) continue;
    std::memcpy(&samples[k], wall, sizeof samples[k]);
  }
}

}  // namespace

Layer compose(const SphereLayer& spheres, const WallLayer* walls, int supersampling) {
  const PixelWindow& window = spheres.window();
  std::vector<std::uint32_t> samples(window.pixels());
  for (int row = 0; row < window.height; ++row) {
    compose_row(spheres, walls, row, &samples[static_cast<std::size_t>(row) * window.width]);
  }
  return average_down(reinterpret_cast<const std::uint8_t*>(samples.data()), window.width, window.height,
                      supersampling);
}

}  // namespace packstone::viz
