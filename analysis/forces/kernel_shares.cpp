#include "analysis/forces/kernel_shares.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace packstone::analysis {

namespace {

constexpr double widest_part = 1.1;  // of a cell around a sample, in kernel widths
constexpr double longest_piece = 2;  // of a line for Gauss's rule, in kernel widths

using Eight = CoarseKernel::Eight;
constexpr std::size_t eight = Eight::SizeAtCompileTime;

struct GaussPoint {
  double at, weight;
};

/// On the interval from 0 to 1.
const std::array gauss_rule = {GaussPoint{0.5 - std::sqrt(0.15), 5.0 / 18}, GaussPoint{0.5, 8.0 / 18},
                               GaussPoint{0.5 + std::sqrt(0.15), 5.0 / 18}};

std::ptrdiff_t floor_ratio(std::ptrdiff_t a, std::ptrdiff_t b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

KernelShares::KernelShares(const RegularGrid& grid, const std::array<bool, 3>& periodic, const CoarseKernel& kernel)
    : grid_(grid), periodic_(periodic), kernel_(kernel) {
  for (int k = 0; k < 3; ++k) {
    parts_[k] = static_cast<std::ptrdiff_t>(std::max(1.0, std::ceil(grid.spacing[k] / (widest_part * kernel.width()))));
    part_[k] = grid.spacing[k] / static_cast<double>(parts_[k]);
  }
}

KernelShares::Samples KernelShares::samples(int axis, double at) const {
  const double place = (at - grid_.origin[axis]) / part_[axis] - 0.5, reach = kernel_.range() / part_[axis];
  Samples samples{static_cast<std::ptrdiff_t>(std::ceil(place - reach)),
                  static_cast<std::ptrdiff_t>(std::floor(place + reach))};
  if (periodic_[axis]) return samples;
  const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(grid_.count[axis]) * parts_[axis] - 1;
  return {std::max<std::ptrdiff_t>(samples.first, 0), std::min(samples.last, end)};  // rounding
}

CellSpan KernelShares::span(int axis, double from, double to) const {
  const auto [low, high] = std::minmax(from, to);
  return {floor_ratio(samples(axis, low).first, parts_[axis]), floor_ratio(samples(axis, high).last, parts_[axis])};
}

void KernelShares::spread(const Vec3& from, const Vec3& to) {
  for (int k = 0; k < 3; ++k) {
    block_[k] = span(k, from[k], to[k]);
    size_[k] = static_cast<std::size_t>(block_[k].last - block_[k].first + 1);
  }
  const auto parts = static_cast<std::size_t>(parts_[0]);
  row_length_ = size_[0] * parts + eight;
  row_.assign(row_length_ * size_[1] * size_[2], 0.0);
  const double length = (to - from).norm();
  if (length == 0) {
    add_kernel(from, 1);
  } else {
    const double pieces = std::ceil(length / (longest_piece * kernel_.width()));
    for (double piece = 0; piece < pieces; ++piece) {
      for (const GaussPoint& point : gauss_rule) {
        add_kernel(from + (piece + point.at) / pieces * (to - from), point.weight);
      }
    }
  }
  share_.clear();
  double sum = 0;
  for (std::size_t row = 0; row < size_[1] * size_[2]; ++row) {
    const double* sample = &row_[row * row_length_];
    for (std::size_t x = 0; x < size_[0]; ++x, sample += parts) {
      share_.push_back(std::accumulate(sample, sample + parts, 0.0));
      sum += share_.back();
    }
  }
  for (double& share : share_) share /= sum;
}

void KernelShares::take_samples(int axis, double at) {
  const Samples range = samples(axis, at);
  AxisSamples& near = near_[axis];
  near.first = range.first;
  near.square.clear();
  near.cell.clear();
  for (std::ptrdiff_t k = range.first; k <= range.last; ++k) {
    const double distance = grid_.origin[axis] + part_[axis] * (static_cast<double>(k) + 0.5) - at;
    near.square.push_back(distance * distance);
    near.cell.push_back(static_cast<std::size_t>(floor_ratio(k, parts_[axis]) - block_[axis].first));
  }
}

void KernelShares::add_kernel(const Vec3& at, double weight) {
  for (int k = 0; k < 3; ++k) take_samples(k, at[k]);
  auto& [x, y, z] = near_;
  const double limit = kernel_.range() * kernel_.range();
  x.square.resize((x.square.size() + eight - 1) / eight * eight, 2 * limit);  // beyond the range, where phi is 0
  const auto first = static_cast<std::size_t>(x.first - block_[0].first * parts_[0]);
  for (std::size_t k = 0; k < z.square.size(); ++k) {
    for (std::size_t j = 0; j < y.square.size(); ++j) {
      const double across = z.square[k] + y.square[j];
      if (across >= limit) continue;
      double* const row = &row_[(z.cell[k] * size_[1] + y.cell[j]) * row_length_ + first];
      for (std::size_t i = 0; i < x.square.size(); i += eight) {
        const Eight squares = Eigen::Map<const Eight>(&x.square[i]) + across;
        Eigen::Map<Eight>(row + i) += weight * kernel_.densities(squares);
      }
    }
  }
}

}  // namespace packstone::analysis
