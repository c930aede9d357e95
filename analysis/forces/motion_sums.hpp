// Sums of mass, momentum and m v (x) v over particles, as one column of numbers.
#pragma once

#include <Eigen/Core>
#include <span>

#include "analysis/forces/stress.hpp"

namespace packstone::analysis {

inline constexpr int tensor_rows = 9;
inline constexpr int mass_row = 0, momentum_row = 1, motion_row = 4, motion_rows = motion_row + tensor_rows;

using MotionColumn = Eigen::Matrix<double, motion_rows, 1>;

/// What one particle adds. velocity: of all particles, or empty.
inline MotionColumn motion_of(const Snapshot& snapshot, std::span<const double> velocity, std::size_t i) {
  MotionColumn motion = MotionColumn::Zero();
  const double mass = snapshot.mass(i);
  motion[mass_row] = mass;
  if (velocity.empty()) return motion;
  const Vec3 v(velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]);
  const Mat3 tensor = mass * v * v.transpose();
  motion.segment<3>(momentum_row) = mass * v;
  motion.segment<tensor_rows>(motion_row) = tensor.reshaped();
  return motion;
}

/// sum m v' (x) v' of summed columns, v' against momentum / mass [J]; 0 without mass.
inline Mat3 fluctuation(const MotionColumn& sums) {
  const double mass = sums[mass_row];
  if (!(mass > 0)) return Mat3::Zero();
  const Vec3 momentum = sums.segment<3>(momentum_row);
  const Mat3 tensor = sums.segment<tensor_rows>(motion_row).reshaped(3, 3);
  return tensor - momentum * momentum.transpose() / mass;
}

}  // namespace packstone::analysis
