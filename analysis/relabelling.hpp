// What numbers would be if the labels lay at random: Monte-Carlo permutation of the particles' types.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "analysis/result.hpp"

namespace packstone::analysis {

/// Mean and standard deviation of a number over random labellings, and the band that holds 95 % of them.
struct RandomReference {
  double mean = 0;
  double deviation = 0;
  std::optional<double> low = {};   ///< 2.5th percentile; none from fewer than 40 labellings
  std::optional<double> high = {};  ///< 97.5th percentile
};

/// Permutations for a system of so many particles: 200 up to 1e5 particles, fewer beyond to bound the work, at
/// least 20.
int permutation_count(std::size_t particles);

/// Every permutation of the labels has its own stream of a fixed seed, so results depend on neither threads nor calls.
std::vector<std::int32_t> permuted(std::span<const std::int32_t> labels, std::uint64_t permutation);

/// Numbers of one labelling; always as many. Called from several threads at once.
using LabelStatistics = std::function<std::vector<double>(std::span<const std::int32_t> labels)>;

/// Mean, sample standard deviation and percentiles (linear between the sorted values) of every number over the
/// permutations (two or more).
std::vector<RandomReference> over_random_labels(std::span<const std::int32_t> labels, int permutations,
                                                const LabelStatistics& statistics);

/// Appends the quantity, its value under random labels (key_random, the standard deviation as uncertainty) and its
/// z-score (key_z = (value - mean) / standard deviation; no value when the standard deviation is 0).
/// model: one sentence that says what "random" is.
void add_with_reference(MeasureResult& result, const Quantity& quantity, const RandomReference& reference,
                        const std::string& model);

/// The same three keys where there is nothing to compare with; neither of the last two has a value.
void add_without_reference(MeasureResult& result, const Quantity& quantity, const std::string& reason);

}  // namespace packstone::analysis
