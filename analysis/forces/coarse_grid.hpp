// Coarse-grained fields on a grid.
#pragma once

#include <filesystem>

#include "analysis/forces/coarse_fields.hpp"
#include "analysis/forces/coarse_sums.hpp"
#include "analysis/regular_grid.hpp"

namespace packstone::analysis {

/// 1 GB of fields.
inline constexpr double most_coarse_cells = 5e6;

/// Fields in the cells of a grid.
struct CoarseGrid : RegularGrid {
  Eigen::Matrix<double, coarse_rows, Eigen::Dynamic> sums;  ///< a column for each cell, as coarse_cell takes them

  CoarseCell at(std::size_t cell) const {
    return coarse_cell(sums.col(static_cast<Eigen::Index>(cell)), cell_volume());
  }
};

/// The fields of coarse_profile in cells about context.options.forces.coarse_cell wide (0: two kernel widths, wider
/// where that makes more cells than particles). Each particle, each branch and each force of a boundary is shared out
/// among the cells by KernelShares, so that the sums over all cells are those over all particles and contacts, to
/// rounding. The grid is the domain along periodic axes, where images count; along the others it reaches over the
/// kernel's range beyond all centres and contacts with boundaries. At rest div(stress) = density gravity + wall_force.
/// O(N x cells within the kernel's range), in parallel along the grid's longest axis; the same bits for any number of
/// threads.
/// No cells without particles, and where all radii are 0. Throws InputError for more than most_coarse_cells, and as
/// kernel_width does.
/// Sources: Goldhirsch, Granular Matter 12 (2010) 239; boundaries: Weinhart et al., Granular Matter 14 (2012) 289.
CoarseGrid coarse_grid(const Snapshot& snapshot, const Context& context, const ForceNetwork& network);

/// Writes the fields of one snapshot as VTK ImageData: solid_fraction; with masses density; with velocities velocity,
/// kinetic_pressure and granular_temperature; with forces stress, contact_stress, pressure and wall_force. Throws
/// InputError where the name does not end in .vti or there is nothing to write, RunError when the disk refuses.
void write_coarse_fields(const std::filesystem::path& path, const Snapshot& snapshot, const Options& options);

}  // namespace packstone::analysis
