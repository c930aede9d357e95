// How far a run has come.
#pragma once

#include <compare>
#include <cstdint>

#include "core/archive.hpp"

namespace packstone {

/// In the order in which it goes.
struct RunMoment {
  std::int64_t phase = 0;  ///< of a run that has several
  std::int64_t step = 0;
  double time = 0;  ///< [s]

  void archive(Archive& a) { a(phase, step, time); }
  friend auto operator<=>(const RunMoment&, const RunMoment&) = default;
};

}  // namespace packstone
