// Sums over many rows by several threads, the same bits for any number of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace packstone::analysis {

/// Sums of add(row, sums) over all rows; every call may add to any of the bins. Equal blocks of rows have sums of their
/// own, which are added in order.
template <class Add>
std::vector<double> blocked_sums(std::size_t rows, std::size_t bins, const Add& add) {
  constexpr std::size_t blocks = 64;
  std::vector<double> partial(blocks * bins, 0.0);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::span<double> sums = std::span(partial).subspan(block * bins, bins);
    for (std::size_t row = rows * block / blocks; row < rows * (block + 1) / blocks; ++row) add(row, sums);
  }
  std::vector<double> total(bins, 0.0);
  for (std::size_t k = 0; k < partial.size(); ++k) total[k % bins] += partial[k];
  return total;
}

}  // namespace packstone::analysis
