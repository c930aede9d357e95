// What particles and contacts add to coarse-grained fields, as one column of numbers.
#pragma once

#include "analysis/forces/coarse_fields.hpp"
#include "analysis/forces/motion_sums.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

/// After the rows of motion the spheres' volume, which ends what particles add; then f (x) l, and the force of
/// boundaries.
inline constexpr int solid_row = motion_rows, particle_rows = solid_row + 1;
inline constexpr int contact_row = particle_rows, wall_row = contact_row + tensor_rows, coarse_rows = wall_row + 3;

using ParticleColumn = Eigen::Matrix<double, particle_rows, 1>;
using CoarseColumn = Eigen::Matrix<double, coarse_rows, 1>;

/// What one particle adds. velocity: of all particles, or empty.
inline ParticleColumn particle_column(const Snapshot& snapshot, std::span<const double> velocity, std::size_t i) {
  ParticleColumn column;
  column << motion_of(snapshot, velocity, i), sphere_volume(snapshot.radius[i]);
  return column;
}

/// The fields of sums over a cell of this volume [m3].
inline CoarseCell coarse_cell(const CoarseColumn& sums, double volume) {
  CoarseCell cell;
  cell.solid_fraction = sums[solid_row] / volume;
  cell.density = sums[mass_row] / volume;
  cell.momentum = sums.segment<3>(momentum_row) / volume;
  cell.contact = sums.segment<tensor_rows>(contact_row).reshaped(3, 3) / volume;
  cell.kinetic = fluctuation(sums.head<motion_rows>()) / volume;
  cell.wall_force = sums.segment<3>(wall_row) / volume;
  return cell;
}

}  // namespace packstone::analysis
