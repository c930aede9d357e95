// Mean and spread of samples.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

namespace packstone::fixtures {

struct Moments {
  double mean;
  double error;      ///< standard deviation of the mean
  double deviation;  ///< of a sample
};

inline Moments moments(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (double v : values) squares += (v - mean) * (v - mean);
  const double deviation = std::sqrt(squares / (n - 1));
  return {mean, deviation / std::sqrt(n), deviation};
}

}  // namespace packstone::fixtures
