#include "analysis/layers.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::analysis {

namespace {

constexpr double rounding_slack = 1e-9;  // layers: a top that exceeds a layer by rounding opens no further layer

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

std::vector<double> volume_by_layer(std::span<const double> height, std::span<const double> radius,
                                    const Layers& layers) {
  std::vector<double> volume(layers.count, 0.0);
  for (std::size_t i = 0; i < height.size(); ++i) {
    for_layer_pieces(height[i], radius[i], layers, Outside::dropped,
                     [&](std::uint32_t layer, double part) { volume[layer] += part; });
  }
  return volume;
}

}  // namespace packstone::analysis
