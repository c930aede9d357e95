// Radical (Laguerre) Voronoi cells of spheres in a convex container, by voro++.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/voronoi/bed_surface.hpp"
#include "analysis/voronoi/container.hpp"

namespace packstone::analysis {

/// What became of a particle's cell.
enum class CellState : std::uint8_t {
  whole,    ///< within the packing
  surface,  ///< has a corner that the surface lies below (BedSurface): the cell holds open space
  empty,    ///< nothing is nearer to this sphere than to larger ones, or voro++ lost the cell
  outside   ///< the particle's centre lies outside the container: it takes no part
};

/// (N) rows each.
struct RadicalCells {
  std::vector<double> volume;        ///< [m3]; 0 where there is no cell
  std::vector<std::uint16_t> faces;  ///< with particles and with the container; 0 where there is no cell
  std::vector<CellState> state;
  double container_volume = 0;  ///< [m3]
};

/// The cell of sphere i holds the points x with |x - x_i|^2 - r_i^2 smallest among all spheres and their periodic
/// images. A tube counts as the prism of equal cross-section whose facets keep within 0.1 % of a mean radius of it; so
/// the volumes of all cells sum up to that of the container within rounding. Of centres that coincide (nearer than 1e-6
/// of the mean distance between particles) the largest sphere, then the first row, takes the cell.
///
/// centre, radius: (N) [m], N > 0, centres inside the container's box along periodic axes. In parallel over blocks of
/// space; every cell is the same for any number of threads.
/// Throws InputError for more than 2^28 particles, and where most of them crowd in a tiny part of the container,
/// which would take hours.
/// Source: Rycroft, Chaos 19 (2009) 041111 (voro++); Gellatly & Finney, J. Non-Cryst. Solids 50
/// (1982) 313 (radical planes).
RadicalCells radical_cells(std::span<const Vec3> centre, std::span<const double> radius, const CellContainer& container,
                           const BedSurface& surface);

}  // namespace packstone::analysis
