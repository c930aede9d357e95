// Local solid fraction on a regular grid.
#pragma once

#include <filesystem>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/packing/container.hpp"
#include "analysis/regular_grid.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// 0.4 GB; a file takes as much again while it is written.
inline constexpr double most_map_cells = 5e7;

struct FractionMap : RegularGrid {
  std::vector<double> fraction;  ///< (cells) solid over the cell's volume, also of cells that a wall cuts
};

/// Exact parts of the spheres in every cell, overlaps counted twice, periodic images too. The grid covers the box about
/// the container from the floor to the highest sphere, within the domain; cells are about context.options.map_cell wide
/// (0: one volume-mean diameter, wider where that makes more than 8 cells a particle) and divide it evenly. The same
/// bits for any number of threads. O(N + cells).
/// No cells without particles or height. Throws InputError for more than most_map_cells.
FractionMap fraction_map(const Snapshot& snapshot, const Context& context, const Container& container);

/// Writes the map as VTK XML ImageData with the cell data "solid_fraction" (float64). Throws InputError where the name
/// does not end in .vti or the map has no cells, RunError when the disk refuses.
void write_vti(const std::filesystem::path& path, const FractionMap& map);

/// Both for one snapshot.
void write_fraction_map(const std::filesystem::path& path, const Snapshot& snapshot, const Options& options);

}  // namespace packstone::analysis
