#include "analysis/segregation/composition.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace packstone::analysis {

namespace {

/// Sums over the particles of a compartment that the random variances need.
struct PieceSums {
  std::vector<double> squares;  // sum w^2
  std::vector<double> crossed;  // sum w v
  std::vector<double> kept;     // sum w^2 / v
};

PieceSums piece_sums(const Division& division, std::span<const double> amount) {
  const std::vector<double> none(division.count, 0.0);
  PieceSums sums{none, none, none};
  for (std::size_t i = 0; i < amount.size(); ++i) {
    division.for_pieces(i, [&](std::uint32_t l, double share) {
      const double w = share * amount[i];
      sums.squares[l] += w * w;
      sums.crossed[l] += w * amount[i];
      sums.kept[l] += w * share;
    });
  }
  return sums;
}

/// Labels exchangeable.
std::vector<double> label_variance(const PieceSums& sums, const SpeciesList& list, const Amounts& amounts,
                                   const Composition& composition) {
  const double n = static_cast<double>(list.label.size());
  double all_squares = 0;
  for (const double v : amounts.of) all_squares += v * v;
  std::vector<double> variance;
  variance.reserve(composition.amount.size());
  for (std::size_t l = 0; l < composition.whole.size(); ++l) {
    const double w = composition.whole[l];
    const double spread = w > 0 ? sums.squares[l] / (w * w) - 2 * sums.crossed[l] / (w * amounts.total) +
                                      all_squares / (amounts.total * amounts.total)
                                : 0.0;
    for (const auto& species : list.species) {
      const double p = static_cast<double>(species.count) / n;
      variance.push_back(p * (1 - p) * n / (n - 1) * spread);
    }
  }
  return variance;
}

/// Amounts linked to type.
std::vector<double> sampling_variance(const PieceSums& sums, const SpeciesList& list, const Amounts& amounts,
                                      const Composition& composition) {
  const double n = static_cast<double>(list.label.size());
  std::vector<double> residual(list.size(), 0.0);  // sum v^2 (x - P)^2
  for (std::size_t i = 0; i < amounts.of.size(); ++i) {
    const double v = amounts.of[i];
    for (std::size_t s = 0; s < list.size(); ++s) {
      const double off = (static_cast<std::size_t>(list.label[i]) == s ? 1.0 : 0.0) - amounts.share(s);
      residual[s] += v * v * off * off;
    }
  }
  std::vector<double> variance;
  variance.reserve(composition.amount.size());
  for (std::size_t l = 0; l < composition.whole.size(); ++l) {
    const double w = composition.whole[l];
    const double spread = w > 0 ? std::max(0.0, sums.kept[l] / (w * w) - 1 / amounts.total) : 0.0;
    for (std::size_t s = 0; s < list.size(); ++s)
      variance.push_back(n / (n - 1) * residual[s] / amounts.total * spread);
  }
  return variance;
}

double total_of(const Composition& c) { return std::accumulate(c.whole.begin(), c.whole.end(), 0.0); }

Composition empty_composition(std::size_t compartments, std::size_t species) {
  return {species, std::vector<double>(compartments * species, 0.0), std::vector<double>(compartments, 0.0),
          std::vector<double>(species, 0.0)};
}

/// The sums over species and over compartments, from the amounts.
void add_up(Composition& c) {
  for (std::size_t l = 0; l < c.whole.size(); ++l) {
    for (std::size_t s = 0; s < c.species; ++s) {
      c.whole[l] += c.amount[l * c.species + s];
      c.mean[s] += c.amount[l * c.species + s];
    }
  }
  const double total = total_of(c);
  for (double& mean : c.mean) mean /= total;
}

}  // namespace

Composition composition_of(const Division& division, std::span<const std::int32_t> label,
                           std::span<const double> amount, std::size_t species) {
  Composition c = empty_composition(division.count, species);
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto s = static_cast<std::size_t>(label[i]);
    division.for_pieces(i, [&](std::uint32_t l, double share) { c.amount[l * species + s] += share * amount[i]; });
  }
  add_up(c);
  return c;
}

Composition layer_composition(std::span<const double> height, std::span<const double> radius, const Layers& layers,
                              std::span<const std::int32_t> label, std::span<const double> amount,
                              std::size_t species) {
  Composition c = empty_composition(layers.count, species);
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto s = static_cast<std::size_t>(label[i]);
    for_layer_shares(height[i], radius[i], layers,
                     [&](std::uint32_t l, double share) { c.amount[l * species + s] += share * amount[i]; });
  }
  add_up(c);
  return c;
}

std::vector<double> variance_by_species(const Composition& c) {
  const double total = total_of(c);
  std::vector<double> variance(c.species, 0.0);
  for (std::size_t l = 0; l < c.whole.size(); ++l) {
    if (c.whole[l] <= 0) continue;
    for (std::size_t s = 0; s < c.species; ++s) {
      const double off = c.share(l, s) - c.mean[s];
      variance[s] += c.whole[l] / total * off * off;
    }
  }
  return variance;
}

double mixing_entropy(const Composition& c) {
  double bed = 0, observed = 0;
  for (const double p : c.mean) bed -= p > 0 ? p * std::log(p) : 0.0;
  if (!(bed > 0)) return 0;
  for (std::size_t l = 0; l < c.whole.size(); ++l) {
    for (std::size_t s = 0; s < c.species; ++s) {
      const double amount = c.amount[l * c.species + s];
      if (amount > 0 && amount < c.whole[l]) observed -= amount * std::log(amount / c.whole[l]);
    }
  }
  return observed / (total_of(c) * bed);
}

std::vector<double> random_variance(const Division& division, const SpeciesList& list, const Amounts& amounts,
                                    const Composition& composition) {
  const PieceSums sums = piece_sums(division, amounts.of);
  return amounts.linked ? sampling_variance(sums, list, amounts, composition)
                        : label_variance(sums, list, amounts, composition);
}

double expected_variance(const std::vector<double>& random_variance, const Composition& c) {
  const double total = total_of(c);
  double mean = 0;
  for (std::size_t l = 0; l < c.whole.size(); ++l) {
    for (std::size_t s = 0; s < c.species; ++s) mean += c.whole[l] / total * random_variance[l * c.species + s];
  }
  return mean;
}

}  // namespace packstone::analysis
