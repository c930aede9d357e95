#include "analysis/layers.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

constexpr double rounding_slack = 1e-9;  // layers: a top that exceeds a layer by rounding opens no further layer
constexpr double farthest_layer = 1e15;  // keeps the index of a lost particle within an integer

std::ptrdiff_t layer_of(double height, const Layers& layers) {
  const double layer = std::floor((height - layers.bottom) / layers.thickness);
  return static_cast<std::ptrdiff_t>(std::clamp(layer, -farthest_layer, farthest_layer));
}

}  // namespace

Layers layers_over_bed(const BedFrame& frame, const std::vector<double>& radius, double thickness) {
  const double height = frame.periodic ? frame.extent : frame.top(radius);
  Layers layers{.bottom = 0, .thickness = thickness, .count = 0, .periodic = frame.periodic};
  if (radius.empty() || !(height > 0) || !(thickness > 0)) return layers;
  const double wanted = height / thickness;
  const double most = static_cast<double>(most_layers);
  if (frame.periodic || wanted > most) {
    layers.count = static_cast<std::size_t>(std::clamp(std::round(wanted), 1.0, most));
    layers.thickness = height / static_cast<double>(layers.count);
  } else {
    layers.count = static_cast<std::size_t>(std::max(1.0, std::ceil(wanted - rounding_slack)));
  }
  return layers;
}

LayerPieces cut_into_layers(std::span<const double> height, std::span<const double> radius, const Layers& layers,
                            Outside outside) {
  LayerPieces pieces;
  pieces.begin.reserve(height.size() + 1);
  pieces.begin.push_back(0);
  const auto count = static_cast<std::ptrdiff_t>(layers.count);
  for (std::size_t i = 0; i < height.size() && count > 0; ++i) {
    const double low = height[i] - radius[i], high = height[i] + radius[i];
    std::ptrdiff_t first = layer_of(low, layers), last = layer_of(high, layers);
    if (!layers.periodic) {
      const std::ptrdiff_t lowest = 0, highest = count - 1;
      const bool keep = outside == Outside::to_nearest_layer;
      first = keep ? std::clamp(first, lowest, highest) : std::max(first, lowest);
      last = keep ? std::clamp(last, lowest, highest) : std::min(last, highest);
    }
    for (std::ptrdiff_t k = first; k <= last; ++k) {
      const bool open_below = outside == Outside::to_nearest_layer && !layers.periodic && k == 0;
      const bool open_above = outside == Outside::to_nearest_layer && !layers.periodic && k == count - 1;
      const double from = layers.bottom + layers.thickness * static_cast<double>(k);
      const double volume = sphere_slab_volume(radius[i], height[i], open_below ? low : from,
                                               open_above ? high : from + layers.thickness);
      if (volume <= 0) continue;
      pieces.layer.push_back(static_cast<std::uint32_t>(((k % count) + count) % count));
      pieces.volume.push_back(volume);
    }
    pieces.begin.push_back(pieces.layer.size());
  }
  return pieces;
}

std::vector<double> volume_by_layer(const LayerPieces& pieces, const Layers& layers) {
  std::vector<double> volume(layers.count, 0.0);
  for (std::size_t k = 0; k < pieces.layer.size(); ++k) volume[pieces.layer[k]] += pieces.volume[k];
  return volume;
}

}  // namespace packstone::analysis
