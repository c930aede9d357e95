// Ranges of logarithmic axes on which at least two powers of ten are named.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace packstone::cli {

/// The range, or the decades around it where it holds fewer than two powers of ten.
inline std::pair<double, double> with_two_decades(std::pair<double, double> range) {
  const double first = std::ceil(std::log10(range.first)), last = std::floor(std::log10(range.second));
  if (last - first >= 1) return range;
  constexpr double beyond = 1.1;  // so that the number has its place
  return {std::min(range.first, std::pow(10, std::floor(std::log10(range.first))) / beyond),
          std::max(range.second, std::pow(10, std::ceil(std::log10(range.second))) * beyond)};
}

}  // namespace packstone::cli
