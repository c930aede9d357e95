#include "analysis/structure/pair_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/structure/point_grid.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"

namespace packstone::analysis {

namespace {

constexpr std::uint64_t sample_seed = 20260101;  // fixed: the same packing gives the same numbers
constexpr double pair_budget = 1.5e7;            // pairs counted at most, about
constexpr std::size_t fewest_references = 1000;
constexpr std::size_t blocks = 32;   // of references, summed each by one thread
constexpr double cells_a_range = 4;  // cells of the search along the range

/// Weights that fell into a bin, and their squares.
struct Weights {
  double sum = 0, squares = 0;
};

struct Sample {
  std::vector<std::uint32_t> rows;        // in the window
  std::vector<std::uint32_t> references;  // of them
};

Sample sampled(const Snapshot& snapshot, const Window& window, double range) {
  Sample sample;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    if (window.contains(snapshot.domain.wrapped(snapshot.position[i]))) {
      sample.rows.push_back(static_cast<std::uint32_t>(i));
    }
  }
  const double density = static_cast<double>(sample.rows.size()) / window.volume();
  const double affordable = pair_budget / std::max(1.0, density * sphere_volume(range));
  const auto wanted = std::max(fewest_references, static_cast<std::size_t>(affordable));
  sample.references = sample.rows;
  if (wanted < sample.rows.size()) {
    Random random(sample_seed, RandomStream::reference_sample, 0);
    shuffle(sample.references, random);
    sample.references.resize(wanted);
    std::sort(sample.references.begin(), sample.references.end());  // near each other in memory
  }
  return sample;
}

/// Place of the curve of labels a and b among those of labels a <= b.
std::size_t curve_of(std::size_t a, std::size_t b, std::size_t labels) {
  const std::size_t low = std::min(a, b), high = std::max(a, b);
  return low * labels - low * (low + 1) / 2 + high;
}

std::vector<std::size_t> counts_by_label(const std::vector<std::uint32_t>& rows, std::span<const std::int32_t> label,
                                         std::size_t labels) {
  std::vector<std::size_t> counts(labels, 0);
  for (const std::uint32_t row : rows) ++counts[static_cast<std::size_t>(label[row])];
  return counts;
}

double shell_volume(std::size_t k, double bin) {
  const double inner = static_cast<double>(k), cells = 3 * inner * inner + 3 * inner + 1;
  return 4.0 / 3.0 * std::numbers::pi * bin * bin * bin * cells;
}

}  // namespace

PairDistribution pair_distribution(const Snapshot& snapshot, const Window& window, std::span<const std::int32_t> label,
                                   std::size_t labels, double bin, std::size_t bins) {
  const double range = bin * static_cast<double>(bins);
  const Sample sample = sampled(snapshot, window, range);
  const PointGrid grid(snapshot.position, sample.rows, snapshot.domain, range / cells_a_range);

  // The total is the sum over the types, so without types it is the only curve.
  const std::size_t kinds = std::max<std::size_t>(labels, 1);
  const std::size_t curves = kinds * (kinds + 1) / 2;
  std::vector<std::vector<Weights>> partial(blocks);
  const std::size_t references = sample.references.size();
#pragma omp parallel for schedule(dynamic)
  for (std::size_t b = 0; b < blocks; ++b) {
    partial[b].resize(curves * bins);
    for (std::size_t k = references * b / blocks; k < references * (b + 1) / blocks; ++k) {
      const std::uint32_t i = sample.references[k];
      grid.for_each_within(snapshot.position[i], range, [&](std::uint32_t j, const Vec3& d, double squared) {
        if (j == i) return;
        const auto at = std::min(static_cast<std::size_t>(std::sqrt(squared) / bin), bins - 1);
        const std::size_t curve =
            labels == 0 ? 0 : curve_of(static_cast<std::size_t>(label[i]), static_cast<std::size_t>(label[j]), labels);
        const double weight = 1 / window.shared_when_moved(d);
        Weights& weights = partial[b][curve * bins + at];
        weights.sum += weight;
        weights.squares += weight * weight;
      });
    }
  }
  std::vector<Weights> weights(curves * bins), total(bins);
  for (const auto& block : partial) {
    for (std::size_t k = 0; k < weights.size(); ++k) {
      weights[k].sum += block[k].sum;
      weights[k].squares += block[k].squares;
    }
  }
  for (std::size_t k = 0; k < weights.size(); ++k) {
    total[k % bins].sum += weights[k].sum;
    total[k % bins].squares += weights[k].squares;
  }

  const double all = static_cast<double>(sample.rows.size()), centres = static_cast<double>(references);
  const double twice = 1 + centres / std::max(1.0, all);
  const auto curve_from = [&](const Weights* each, double pairs) {
    PairCurve curve{std::vector<double>(bins, 0.0), std::vector<double>(bins, 0.0)};
    const double volume = window.volume();
    for (std::size_t k = 0; k < bins && pairs > 0; ++k) {
      const double factor = volume * volume / (shell_volume(k, bin) * pairs);
      curve.g[k] = factor * each[k].sum;
      curve.error[k] = factor * std::sqrt(twice * each[k].squares);
    }
    return curve;
  };
  PairDistribution result{.bin = bin, .bins = bins, .particles = sample.rows.size(), .references = references};
  result.total = curve_from(total.data(), centres * (all - 1));
  if (labels == 0) return result;
  const auto number = counts_by_label(sample.rows, label, labels);
  const auto number_of_references = counts_by_label(sample.references, label, labels);
  for (std::size_t a = 0; a < labels; ++a) {
    for (std::size_t b = a; b < labels; ++b) {
      const double n_a = static_cast<double>(number[a]), n_b = static_cast<double>(number[b]);
      const double m_a = static_cast<double>(number_of_references[a]),
                   m_b = static_cast<double>(number_of_references[b]);
      const double pairs = a == b ? m_a * (n_a - 1) : m_a * n_b + m_b * n_a;
      result.partial.push_back(curve_from(weights.data() + curve_of(a, b, labels) * bins, pairs));
    }
  }
  return result;
}

}  // namespace packstone::analysis
