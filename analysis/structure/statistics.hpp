// Mean of a sample and its standard error.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

#include "analysis/result.hpp"

namespace packstone::analysis {

/// Sets the mean of one or more values and, from two on, its standard error: standard deviation over sqrt(N), as if the
/// values were independent.
template <class Number>
void set_mean(Quantity& quantity, const std::vector<Number>& values) {
  const double n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  quantity.value = mean;
  if (values.size() < 2) return;
  double squares = 0;
  for (const Number v : values) squares += (v - mean) * (v - mean);
  quantity.uncertainty = std::sqrt(squares / (n - 1) / n);
}

/// Standard error of a share of n independent items (binomial).
inline double share_error(double share, std::size_t n) {
  return std::sqrt(share * (1 - share) / static_cast<double>(n));
}

}  // namespace packstone::analysis
