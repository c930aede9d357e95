// What work costs on a machine that has other work besides.
#pragma once

#include <algorithm>
#include <ctime>
#include <functional>
#include <vector>

namespace packstone::cli {

/// That this process has used on all of its threads [s]: hardly depends on what else the machine does.
inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  constexpr double nano = 1e-9;
  return static_cast<double>(time.tv_sec) + nano * static_cast<double>(time.tv_nsec);
}

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
