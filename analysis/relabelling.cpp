#include "analysis/relabelling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"

namespace packstone::analysis {

namespace {

constexpr std::uint64_t permutation_seed = 20090101;  // fixed: the same packing gives the same numbers
constexpr std::size_t label_budget = 20'000'000;      // labels drawn in all
constexpr std::size_t most_permutations = 200;
constexpr std::size_t fewest_permutations = 20;
constexpr double negligible_deviation = 1e-12;  // of the mean: rounding, not spread

constexpr double band_tail = 0.025;          // of the labellings beyond each end of the band
constexpr std::size_t fewest_for_band = 40;  // one labelling in each tail

/// Linear between the sorted values.
double percentile(const std::vector<double>& sorted, double share) {
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

RandomReference summarised(const std::vector<std::vector<double>>& samples, std::size_t k) {
  const double n = static_cast<double>(samples.size());
  double mean = 0, squares = 0;
  for (const auto& sample : samples) mean += sample[k] / n;
  for (const auto& sample : samples) squares += (sample[k] - mean) * (sample[k] - mean);
  RandomReference reference{mean, std::sqrt(squares / (n - 1))};
  if (samples.size() < fewest_for_band) return reference;
  std::vector<double> sorted;
  for (const auto& sample : samples) sorted.push_back(sample[k]);
  std::sort(sorted.begin(), sorted.end());
  reference.low = percentile(sorted, band_tail);
  reference.high = percentile(sorted, 1 - band_tail);
  return reference;
}

Quantity random_quantity(const Quantity& quantity, const std::string& model) {
  return {.key = quantity.key + "_random",
          .label = quantity.label + ", random",
          .unit = quantity.unit,
          .definition = "mean and standard deviation of " + quantity.key + " in " + model};
}

Quantity z_quantity(const Quantity& quantity) {
  return {.key = quantity.key + "_z",
          .label = quantity.label + ", z-score",
          .definition = "(" + quantity.key + " - mean) / standard deviation of " + quantity.key + "_random"};
}

}  // namespace

int permutation_count(std::size_t particles) {
  const std::size_t affordable = label_budget / std::max<std::size_t>(particles, 1);
  return static_cast<int>(std::clamp(affordable, fewest_permutations, most_permutations));
}

std::vector<std::int32_t> permuted(std::span<const std::int32_t> labels, std::uint64_t permutation) {
  std::vector<std::int32_t> result(labels.begin(), labels.end());
  Random random(permutation_seed, RandomStream::label_permutation, permutation);
  shuffle(result, random);
  return result;
}

std::vector<RandomReference> over_random_labels(std::span<const std::int32_t> labels, int permutations,
                                                const LabelStatistics& statistics) {
  std::vector<std::vector<double>> samples(static_cast<std::size_t>(permutations));
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < permutations; ++k) samples[k] = statistics(permuted(labels, static_cast<std::uint64_t>(k)));
  std::vector<RandomReference> references;
  for (std::size_t k = 0; k < samples.front().size(); ++k) references.push_back(summarised(samples, k));
  return references;
}

void add_with_reference(MeasureResult& result, const Quantity& quantity, const RandomReference& reference,
                        const std::string& model) {
  Quantity random = random_quantity(quantity, model);
  random.value = reference.mean;
  random.uncertainty = reference.deviation;
  Quantity z = z_quantity(quantity);
  if (reference.deviation > negligible_deviation * std::abs(reference.mean)) {
    z.value = (*quantity.value - reference.mean) / reference.deviation;
  } else {
    z = not_applicable(z, "random labels always give the same value");
  }
  for (const Quantity& q : {quantity, random, z}) result.quantities.push_back(q);
}

void add_without_reference(MeasureResult& result, const Quantity& quantity, const std::string& reason) {
  result.quantities.push_back(quantity);
  result.quantities.push_back(not_applicable(random_quantity(quantity, "random labels"), reason));
  result.quantities.push_back(not_applicable(z_quantity(quantity), reason));
}

}  // namespace packstone::analysis
