#include "analysis/segregation/composition.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

/// Sums over the particles of a layer that the random variances need.
struct LayerSums {
  std::vector<double> squares;  // sum w^2 [m6]
  std::vector<double> crossed;  // sum w v [m6]
  std::vector<double> kept;     // sum w^2 / v [m3]
};

LayerSums layer_sums(const LayerPieces& pieces, std::size_t layers, std::span<const double> radius) {
  LayerSums sums{std::vector<double>(layers, 0.0), std::vector<double>(layers, 0.0), std::vector<double>(layers, 0.0)};
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double v = sphere_volume(radius[i]);
    for (std::size_t k = pieces.begin[i]; k < pieces.begin[i + 1]; ++k) {
      const double w = pieces.volume[k];
      sums.squares[pieces.layer[k]] += w * w;
      sums.crossed[pieces.layer[k]] += w * v;
      sums.kept[pieces.layer[k]] += w * (w / v);
    }
  }
  return sums;
}

/// (layers * species), labels exchangeable.
std::vector<double> label_variance(const LayerSums& sums, const SpeciesList& list, const Composition& composition,
                                   std::span<const double> radius) {
  const double n = static_cast<double>(list.label.size());
  double all_squares = 0;
  for (double r : radius) all_squares += sphere_volume(r) * sphere_volume(r);
  std::vector<double> variance;
  for (std::size_t l = 0; l < composition.layer.size(); ++l) {
    const double w = composition.layer[l];
    const double spread = w > 0 ? sums.squares[l] / (w * w) - 2 * sums.crossed[l] / (w * list.volume) +
                                      all_squares / (list.volume * list.volume)
                                : 0.0;
    for (const auto& species : list.species) {
      const double p = static_cast<double>(species.count) / n;
      variance.push_back(p * (1 - p) * n / (n - 1) * spread);
    }
  }
  return variance;
}

/// (layers * species), sizes linked to type.
std::vector<double> sampling_variance(const LayerSums& sums, const SpeciesList& list, const Composition& composition,
                                      std::span<const double> radius) {
  const double n = static_cast<double>(list.label.size());
  std::vector<double> residual(list.size(), 0.0);  // sum v^2 (x - P)^2
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double v = sphere_volume(radius[i]);
    for (std::size_t s = 0; s < list.size(); ++s) {
      const double off = (static_cast<std::size_t>(list.label[i]) == s ? 1.0 : 0.0) - list.share(s);
      residual[s] += v * v * off * off;
    }
  }
  std::vector<double> variance;
  for (std::size_t l = 0; l < composition.layer.size(); ++l) {
    const double w = composition.layer[l];
    const double spread = w > 0 ? std::max(0.0, sums.kept[l] / (w * w) - 1 / list.volume) : 0.0;
    for (std::size_t s = 0; s < list.size(); ++s) variance.push_back(n / (n - 1) * residual[s] / list.volume * spread);
  }
  return variance;
}

/// Mean of s^2 from the variances; its deviation for independent normal layers, species - 1 of them free.
RandomReference normal_reference(const RandomMixing& mixing, const Composition& composition, double volume) {
  RandomReference reference;
  double squares = 0;
  for (std::size_t l = 0; l < composition.layer.size(); ++l) {
    const auto first = mixing.variance.begin() + static_cast<std::ptrdiff_t>(l * mixing.species);
    const double of_layer = std::accumulate(first, first + static_cast<std::ptrdiff_t>(mixing.species), 0.0);
    const double weighted = composition.layer[l] / volume * of_layer;
    reference.mean += weighted;
    squares += 2 * weighted * weighted / static_cast<double>(mixing.species - 1);
  }
  reference.deviation = std::sqrt(squares);
  return reference;
}

}  // namespace

Composition composition_of(const LayerPieces& pieces, const Layers& layers, std::span<const std::int32_t> label,
                           std::size_t species) {
  Composition c{species, std::vector<double>(layers.count * species, 0.0), std::vector<double>(layers.count, 0.0),
                std::vector<double>(species, 0.0)};
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto s = static_cast<std::size_t>(label[i]);
    for (std::size_t k = pieces.begin[i]; k < pieces.begin[i + 1]; ++k) {
      c.volume[pieces.layer[k] * species + s] += pieces.volume[k];
      c.layer[pieces.layer[k]] += pieces.volume[k];
      c.mean[s] += pieces.volume[k];
    }
  }
  const double total = std::accumulate(c.mean.begin(), c.mean.end(), 0.0);
  for (double& mean : c.mean) mean /= total;
  return c;
}

std::vector<double> variance_over_layers(const Composition& c) {
  const double total = std::accumulate(c.layer.begin(), c.layer.end(), 0.0);
  std::vector<double> variance(c.species, 0.0);
  for (std::size_t l = 0; l < c.layer.size(); ++l) {
    if (c.layer[l] <= 0) continue;
    for (std::size_t s = 0; s < c.species; ++s) {
      const double off = c.share(l, s) - c.mean[s];
      variance[s] += c.layer[l] / total * off * off;
    }
  }
  return variance;
}

RandomMixing random_mixing(const LayerPieces& pieces, const Layers& layers, const SpeciesList& list,
                           const Composition& composition, std::span<const double> radius) {
  RandomMixing mixing;
  mixing.species = list.size();
  mixing.size_linked = list.size_linked();
  const LayerSums sums = layer_sums(pieces, layers.count, radius);
  mixing.variance = mixing.size_linked ? sampling_variance(sums, list, composition, radius)
                                       : label_variance(sums, list, composition, radius);
  mixing.total = normal_reference(mixing, composition, list.volume);
  mixing.expected = mixing.total.mean;
  if (mixing.size_linked) return mixing;
  const auto total_variance = [&](std::span<const std::int32_t> label) {
    const auto variance = variance_over_layers(composition_of(pieces, layers, label, list.size()));
    return std::vector<double>{std::accumulate(variance.begin(), variance.end(), 0.0)};
  };
  mixing.total = over_random_labels(list.label, permutation_count(list.label.size()), total_variance).front();
  return mixing;
}

}  // namespace packstone::analysis
