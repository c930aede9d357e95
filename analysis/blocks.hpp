// Sums over many items by all threads, the same bits for any number of them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace packstone::analysis {

/// Sum over the items 0 .. n-1: each of a fixed number of blocks is summed in order from zero, then the blocks are.
/// zero: a value with +=; add(sum, item) adds one item and must not throw.
template <class Sum, class Add>
Sum sum_in_blocks(std::size_t n, const Sum& zero, Add&& add) {
  constexpr std::size_t most_blocks = 64, items_worth_a_block = 1024;
  const std::size_t blocks = std::clamp<std::size_t>(n / items_worth_a_block, 1, most_blocks);
  std::vector<Sum> partial(blocks, zero);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t k = n * b / blocks; k < n * (b + 1) / blocks; ++k) add(partial[b], k);
  }
  Sum total = zero;
  for (const Sum& each : partial) total += each;
  return total;
}

/// Sums in bins: add(sums, item) may add to any of them.
template <class Add>
std::vector<double> bins_in_blocks(std::size_t n, std::size_t bins, Add&& add) {
  const Eigen::VectorXd sums = sum_in_blocks(n, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bins)).eval(), add);
  return {sums.begin(), sums.end()};
}

}  // namespace packstone::analysis
