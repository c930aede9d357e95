// The bed divided into compartments: layers, rings or cells.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/layers.hpp"
#include "core/bed_frame.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// Which particles, or which parts of them, lie in which compartment.
struct Division {
  std::size_t count = 0;                        ///< of compartments
  std::vector<std::uint32_t> compartment = {};  ///< of a piece
  std::vector<double> share = {};       ///< of its particle that a piece is; empty: particles lie whole, by centre
  std::vector<std::size_t> begin = {};  ///< (N + 1) pieces of particle i; empty: piece i is particle i

  /// function(compartment, share) for every piece of a particle.
  template <class Function>
  void for_pieces(std::size_t particle, Function function) const {
    if (share.empty()) {
      function(compartment[particle], 1.0);
      return;
    }
    for (std::size_t k = begin[particle]; k < begin[particle + 1]; ++k) function(compartment[k], share[k]);
  }
};

/// The bed's layers along an axis of the domain instead of up: heights count from the lowest point of any sphere, or
/// from the lower face where the domain is periodic along the axis.
BedFrame frame_along(const Snapshot& snapshot, const BedFrame& up, int axis);

/// function(layer, share) for every part of one particle, share of its volume; what lies outside belongs to the nearest
/// layer, and so does a particle without volume, by its centre.
template <class Function>
void for_layer_shares(double height, double radius, const Layers& layers, Function function) {
  const double whole = sphere_volume(radius);
  if (whole > 0) {
    for_layer_pieces(height, radius, layers, Outside::to_nearest_layer,
                     [&](std::uint32_t layer, double volume) { function(layer, volume / whole); });
  } else {
    const auto count = static_cast<std::ptrdiff_t>(layers.count);
    const std::ptrdiff_t layer = layers.at(height), lowest = 0;
    const std::ptrdiff_t inside =
        layers.periodic ? (layer % count + count) % count : std::clamp(layer, lowest, count - 1);
    function(static_cast<std::uint32_t>(inside), 1.0);
  }
}

/// Of all particles.
Division divided_into_layers(const BedFrame& frame, std::span<const double> radius, const Layers& layers);

/// Rings of equal area about an axis out to the farthest centre.
struct Rings {
  Vec3 centre = Vec3::Zero();  ///< a point of the axis [m]
  int axis = 2;
  double reach = 0;  ///< of the farthest centre from the axis [m]
  std::size_t count = 0;
  std::string missing = {};  ///< why there are none

  double outer(std::size_t ring) const;  ///< radius [m]
  double inner(std::size_t ring) const { return ring == 0 ? 0 : outer(ring - 1); }
};

/// Rings about the axis of the narrowest boundary that encloses a cross-section along it, else about the middle of the
/// domain. wanted: their number; 0: the outermost is about one diameter [m] wide, at least two rings.
Rings rings_about(const Snapshot& snapshot, int axis, std::size_t wanted, double diameter);

Division divided_into_rings(const Snapshot& snapshot, const Rings& rings);

/// A box in which all particles lie, divided evenly.
struct CellGrid {
  Vec3 low = Vec3::Zero();  ///< corner [m]
  Vec3 size = Vec3::Zero();
  std::array<std::size_t, 3> count = {1, 1, 1};

  double edge() const;  ///< of the cube of a cell's volume [m]
};

/// Along the longest side of the box around all spheres (the domain along periodic axes). Needs a particle.
int longest_axis(const Snapshot& snapshot);

/// The box around all spheres (the domain along periodic axes) in cells as near to cubes of the edge [m] as divide it
/// evenly; larger ones where there would be more than eight to a particle. Needs a particle; edge > 0.
CellGrid cell_grid(const Snapshot& snapshot, double edge);

/// By centres; cells without any are left out.
Division divided_into_cells(const Snapshot& snapshot, const CellGrid& grid);

/// Grids from the edge [m] to the whole box, edges in a constant ratio, each grid once, at least two cells.
std::vector<CellGrid> grids_of_all_scales(const Snapshot& snapshot, double finest_edge);

}  // namespace packstone::analysis
