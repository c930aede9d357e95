// Horizontal layers of equal thickness, and the exact volume of every sphere in each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bed_frame.hpp"

namespace packstone::analysis {

/// Layers stacked from a height upwards.
struct Layers {
  double bottom = 0;     ///< of the lowest layer [m]
  double thickness = 0;  ///< [m]
  std::size_t count = 0;
  bool periodic = false;  ///< the uppermost layer lies below the lowest again

  double lower(std::size_t layer) const { return bottom + thickness * static_cast<double>(layer); }
  double upper(std::size_t layer) const { return lower(layer + 1); }
};

/// At most so many layers: one particle far above the bed must not fill the memory.
inline constexpr std::size_t most_layers = 2000;

/// Layers of about the wanted thickness [m] from the floor to the top of the highest sphere, or through the whole
/// domain where it is periodic along up (then the thickness divides it evenly). None without particles.
Layers layers_over_bed(const BedFrame& frame, const std::vector<double>& radius, double thickness);

/// The parts of all spheres by layer, particle after particle.
struct LayerPieces {
  std::vector<std::size_t> begin;    ///< (N + 1) pieces of particle i are [begin[i], begin[i + 1])
  std::vector<std::uint32_t> layer;  ///< of a piece
  std::vector<double> volume;        ///< of a piece [m3]
};

/// What to do with the part of a sphere outside the layers of a stack that is not periodic.
enum class Outside { dropped, to_nearest_layer };

LayerPieces cut_into_layers(std::span<const double> height, std::span<const double> radius, const Layers& layers,
                            Outside outside);

/// Solid volume of every layer [m3].
std::vector<double> volume_by_layer(const LayerPieces& pieces, const Layers& layers);

}  // namespace packstone::analysis
