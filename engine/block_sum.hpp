// Sums on all threads that have the same bits for any number of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/threads.hpp"

namespace packstone::engine {

/// Particles for which a loop that only adds up or copies is worth a further thread, over those of a step's.
inline constexpr std::size_t light_share = 16;

/// term(0) + ... + term(n-1).
template <class Value, class Term>
Value sum_in_blocks(std::size_t n, const Value& zero, const Term& term) {
  constexpr std::size_t block = 1024;
  std::vector<Value> sums((n + block - 1) / block, zero);
  const auto blocks = static_cast<std::ptrdiff_t>(sums.size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(n / light_share))
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    const std::size_t begin = b * block;
    for (std::size_t k = begin; k < std::min(begin + block, n); ++k) sums[b] += term(k);
  }
  Value total = zero;
  for (const Value& sum : sums) total += sum;
  return total;
}

/// use(0) ... use(n-1), on all threads.
template <class Use>
void for_each_index(std::size_t n, const Use& use) {
  const auto count = static_cast<std::ptrdiff_t>(n);
#pragma omp parallel for schedule(static) num_threads(useful_threads(n / light_share))
  for (std::ptrdiff_t k = 0; k < count; ++k) use(static_cast<std::size_t>(k));
}

}  // namespace packstone::engine
