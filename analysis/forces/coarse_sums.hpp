// What particles and contacts add to coarse-grained fields, as one column of numbers.
#pragma once

#include "analysis/forces/coarse_fields.hpp"
#include "analysis/forces/motion_sums.hpp"

namespace packstone::analysis {

/// After the rows of motion: f (x) l, then the force of boundaries.
inline constexpr int contact_row = motion_rows, wall_row = contact_row + tensor_rows, coarse_rows = wall_row + 3;

using CoarseColumn = Eigen::Matrix<double, coarse_rows, 1>;

/// The fields of sums over a cell of this volume [m3].
inline CoarseCell coarse_cell(const CoarseColumn& sums, double volume) {
  CoarseCell cell;
  cell.density = sums[mass_row] / volume;
  cell.momentum = sums.segment<3>(momentum_row) / volume;
  cell.contact = sums.segment<tensor_rows>(contact_row).reshaped(3, 3) / volume;
  cell.kinetic = fluctuation(sums.head<motion_rows>()) / volume;
  cell.wall_force = sums.segment<3>(wall_row) / volume;
  return cell;
}

}  // namespace packstone::analysis
