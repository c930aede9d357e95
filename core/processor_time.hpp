// Processor time of this process, on all of its threads: unlike wall time it hardly depends on what else the machine does.
#pragma once

#include <ctime>

namespace packstone {

/// Used so far [s].
inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  constexpr double nano = 1e-9;
  return static_cast<double>(time.tv_sec) + nano * static_cast<double>(time.tv_nsec);
}

}  // namespace packstone
