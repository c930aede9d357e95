// How many threads are worth waking.
#pragma once

#include <algorithm>
#include <cstddef>

#include <omp.h>

namespace packstone::engine {

/// A step of fewer particles than this takes less time than waking a further thread.
inline constexpr std::size_t particles_per_thread = 500;

inline int useful_threads(std::size_t particles) {
  const auto worth = static_cast<int>(std::min<std::size_t>(particles / particles_per_thread + 1, 1 << 16));
  return std::min(omp_get_max_threads(), worth);
}

}  // namespace packstone::engine
