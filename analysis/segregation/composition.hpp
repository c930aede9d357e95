// Composition by layer, its variance, and what random mixing would make of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/layers.hpp"
#include "analysis/relabelling.hpp"
#include "analysis/species.hpp"

namespace packstone::analysis {

/// Solid volume by layer and species.
struct Composition {
  std::size_t species = 0;
  std::vector<double> volume;  ///< (layers * species) [m3]
  std::vector<double> layer;   ///< (layers) of all species [m3]
  std::vector<double> mean;    ///< (species) share of the whole bed

  double share(std::size_t layer_index, std::size_t s) const {
    return volume[layer_index * species + s] / layer[layer_index];
  }
};

Composition composition_of(const LayerPieces& pieces, const Layers& layers, std::span<const std::int32_t> label,
                           std::size_t species);

/// (species) variance of a species' share over the layers, weighted by solid volume:
///   s^2 = sum_l W_l (c_l - P)^2 / sum_l W_l,  c_l share in layer l, W_l its solid, P share of the whole bed.
std::vector<double> variance_over_layers(const Composition& composition);

/// What random mixing gives, layer by layer.
struct RandomMixing {
  std::size_t species = 0;
  std::vector<double> variance;  ///< (layers * species) of c_l - P
  double expected = 0;           ///< of s^2, summed over the species, from these variances
  RandomReference total;         ///< of the same s^2
  bool size_linked = false;      ///< which model it is, see random_mixing
};

/// Variances of c_l - P under random mixing; w_i volume of particle i in the layer, v_i its whole volume, V = sum v.
///
/// Sizes independent of type: labels permuted at random among the N particles, n of the species, p = n/N. Exact:
///   var = p (1 - p) N/(N - 1) sum_i (w_i/W - v_i/V)^2.
/// For equal spheres this is p (1 - p)/n_eff (N - n_eff)/(N - 1) with n_eff = (sum w)^2 / sum w^2: Lacey's
/// p (1 - p)/n (J. Appl. Chem. 4 (1954) 257) with the correction for a finite population and for cut particles.
/// Mean and deviation of s^2: 200 permutations (fewer above 1e5 particles).
///
/// Sizes linked to type (SpeciesList::size_linked): labels cannot change places without sizes. A layer is then a random
/// sample of W m3 of the mixture; with x_i = 1 for the species, to first order (ratio estimate, Cochran, Sampling
/// Techniques (1977), ch. 6):
///   var = N/(N - 1) sum_i v_i^2 (x_i - P)^2 / V (k/W - 1/V),  k = sum_i (w_i/W) (w_i/v_i) for the cut particles;
/// for two sizes without cutting P (1 - P) ((1 - P) v_1 + P v_2)/W (Stange, Chem.-Ing.-Tech. 26 (1954) 331).
/// Exact for equal spheres. Mean of s^2 from it; deviation as if layers were independent and normal.
RandomMixing random_mixing(const LayerPieces& pieces, const Layers& layers, const SpeciesList& list,
                           const Composition& composition, std::span<const double> radius);

}  // namespace packstone::analysis
