// Horizontal layers of equal thickness, and the exact volume of every sphere in each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bed_frame.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

/// Layers stacked from a height upwards.
struct Layers {
  double bottom = 0;     ///< of the lowest layer [m]
  double thickness = 0;  ///< [m]
  std::size_t count = 0;
  bool periodic = false;  ///< the uppermost layer lies below the lowest again

  double lower(std::size_t layer) const { return bottom + thickness * static_cast<double>(layer); }
  double upper(std::size_t layer) const { return lower(layer + 1); }

  /// Index of the layer at a height, as if the stack went on below and above; count must not be 0.
  std::ptrdiff_t at(double height) const {
    constexpr double farthest = 1e15;  // keeps the index of a lost particle within an integer
    return static_cast<std::ptrdiff_t>(std::clamp(std::floor((height - bottom) / thickness), -farthest, farthest));
  }
};

/// At most so many layers: one particle far above the bed must not fill the memory.
inline constexpr std::size_t most_layers = 2000;

/// Layers of about the wanted thickness [m] from the floor to the top of the highest sphere, or through the whole
/// domain where it is periodic along up (then the thickness divides it evenly). None without particles.
Layers layers_over_bed(const BedFrame& frame, const std::vector<double>& radius, double thickness);

/// What to do with the part of a sphere outside the layers of a stack that is not periodic.
enum class Outside { dropped, to_nearest_layer };

/// function(layer, volume) for every part of one sphere, from below [m3].
template <class Function>
void for_layer_pieces(double height, double radius, const Layers& layers, Outside outside, Function function) {
  const auto count = static_cast<std::ptrdiff_t>(layers.count);
  if (count == 0) return;
  const double low = height - radius, high = height + radius;
  const bool keep = outside == Outside::to_nearest_layer && !layers.periodic;
  std::ptrdiff_t first = layers.at(low), last = layers.at(high);
  if (!layers.periodic) {
    const std::ptrdiff_t lowest = 0, highest = count - 1;
    first = keep ? std::clamp(first, lowest, highest) : std::max(first, lowest);
    last = keep ? std::clamp(last, lowest, highest) : std::min(last, highest);
  }
  for (std::ptrdiff_t k = first; k <= last; ++k) {
    const double from = layers.bottom + layers.thickness * static_cast<double>(k);
    const double lower = keep && k == 0 ? low : from;
    const double upper = keep && k == count - 1 ? high : from + layers.thickness;
    const double volume = sphere_slab_volume(radius, height, lower, upper);
    const std::ptrdiff_t layer = layers.periodic ? ((k % count) + count) % count : k;
    if (volume > 0) function(static_cast<std::uint32_t>(layer), volume);
  }
}

/// Solid volume of every layer [m3]; what lies outside is dropped.
std::vector<double> volume_by_layer(std::span<const double> height, std::span<const double> radius,
                                    const Layers& layers);

}  // namespace packstone::analysis
