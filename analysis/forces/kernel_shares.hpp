// How a kernel spreads over the cells of a grid.
#pragma once

#include <array>
#include <vector>

#include "analysis/forces/item_bands.hpp"
#include "analysis/forces/kernel.hpp"
#include "analysis/regular_grid.hpp"

namespace packstone::analysis {

/// The shares of a kernel, or of its mean along a line, in the cells of a grid. The kernel is sampled at the middles of
/// equal parts of the cells, no wider than 1.1 of its widths, and the shares are scaled to sum up to 1. Without scaling
/// they would miss 1 by 2e-4 at most with Lucy's kernel and 6e-3 with the Gaussian, which jumps at its cut. The mean
/// along a line is taken by Gauss's rule of three points on pieces no longer than two widths: within 1e-3 of the peak
/// with Lucy's kernel, 4e-3 with the Gaussian.
class KernelShares {
 public:
  /// periodic: axes along which cells count on beyond the ends. The grid's box reaches over the kernel's range beyond
  /// all points along the others. The grid and the kernel must outlive this.
  KernelShares(const RegularGrid& grid, const std::array<bool, 3>& periodic, const CoarseKernel& kernel);

  /// The cells along an axis that spread() between these coordinates along it gives shares to, or more.
  CellSpan span(int axis, double from, double to) const;

  /// The kernel's mean along the line between two points, or the kernel at a point.
  void spread(const Vec3& from, const Vec3& to);
  void spread(const Vec3& at) { spread(at, at); }

  /// Calls visit(cell, share) for all cells with a share; a cell twice where images of the kernel meet in it.
  template <class Visit>
  void for_each(Visit&& visit) const;

 private:
  struct Samples {
    std::ptrdiff_t first, last;  // parts of cells along an axis, within the range of a point
  };

  /// Samples along an axis near a point.
  struct AxisSamples {
    std::ptrdiff_t first;
    std::vector<double> square;     // of the distance [m2]
    std::vector<std::size_t> cell;  // of the block
  };

  Samples samples(int axis, double at) const;
  void take_samples(int axis, double at);
  void add_kernel(const Vec3& at, double weight);

  /// Index along an axis of the grid.
  std::size_t wrapped(int axis, std::ptrdiff_t cell) const {
    const auto count = static_cast<std::ptrdiff_t>(grid_.count[axis]);
    return static_cast<std::size_t>(periodic_[axis] ? ((cell % count) + count) % count : cell);
  }

  const RegularGrid& grid_;
  std::array<bool, 3> periodic_;
  const CoarseKernel& kernel_;
  std::array<std::ptrdiff_t, 3> parts_;  // of a cell along each axis
  Vec3 part_;                            // sides of one [m]
  std::array<AxisSamples, 3> near_;      // within the range of a point
  std::array<CellSpan, 3> block_{};      // of the cells at hand
  std::array<std::size_t, 3> size_{};    // of the block
  std::vector<double> share_;            // of its cells, x fastest
  std::vector<double> row_;              // of samples along x, of each row of its cells
  std::size_t row_length_ = 0;           // longer than the samples are: eight are taken at once
};

template <class Visit>
void KernelShares::for_each(Visit&& visit) const {
  const auto step = [&](int axis, std::size_t& index) {
    if (++index == grid_.count[axis]) index = 0;
  };
  const double* share = share_.data();
  std::size_t z = wrapped(2, block_[2].first);
  for (std::size_t k = 0; k < size_[2]; ++k, step(2, z)) {
    std::size_t y = wrapped(1, block_[1].first);
    for (std::size_t j = 0; j < size_[1]; ++j, step(1, y)) {
      const std::size_t row = (z * grid_.count[1] + y) * grid_.count[0];
      std::size_t x = wrapped(0, block_[0].first);
      for (std::size_t i = 0; i < size_[0]; ++i, ++share, step(0, x)) {
        if (*share > 0) visit(row + x, *share);
      }
    }
  }
}

}  // namespace packstone::analysis
