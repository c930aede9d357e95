// Histograms of values over their mean.
#pragma once

#include <span>

#include "analysis/result.hpp"

namespace packstone::analysis {

/// Width of a bin, and how many bins there are at most on each side of 0: so many means.
inline constexpr double histogram_bin = 0.1;
inline constexpr int histogram_bins = 200;

/// Forces whose excess over the mean is below this share of it are equal: rounding, not a distribution.
inline constexpr double equal_forces = 1e-12;

/// The table with columns lower, upper (in means), count and density (probability density of value / mean; integrates
/// to 1), from the bin of the smallest to that of the largest value; what lies beyond 20 means
/// either way counts in the outermost bins.
/// table: key and caption, which is extended. No rows unless mean > 0.
Table histogram(Table table, std::span<const double> values, double mean);

}  // namespace packstone::analysis
