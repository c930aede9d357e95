// What repeated work costs on a machine that has other work besides.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "core/processor_time.hpp"

namespace packstone::cli {

/// Median of what the work takes over several times, after one that is not counted [s].
inline double median_processor_seconds(int times, const std::function<void()>& work) {
  work();
  std::vector<double> seconds;
  for (int k = 0; k < times; ++k) {
    const double start = processor_seconds();
    work();
    seconds.push_back(processor_seconds() - start);
  }
  std::nth_element(seconds.begin(), seconds.begin() + times / 2, seconds.end());
  return seconds[static_cast<std::size_t>(times / 2)];
}

}  // namespace packstone::cli
