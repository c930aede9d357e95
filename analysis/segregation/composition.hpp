// Composition by compartment, the numbers that sum it up, and what random mixing would make of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/segregation/amounts.hpp"
#include "analysis/segregation/division.hpp"
#include "analysis/species.hpp"

namespace packstone::analysis {

/// Amounts by compartment and species.
struct Composition {
  std::size_t species = 0;
  std::vector<double> amount;  ///< (compartments * species)
  std::vector<double> whole;   ///< (compartments) of all species
  std::vector<double> mean;    ///< (species) share of the whole bed

  double share(std::size_t compartment, std::size_t s) const {
    return amount[compartment * species + s] / whole[compartment];
  }
};

/// label, amount: (N) of every particle.
Composition composition_of(const Division& division, std::span<const std::int32_t> label,
                           std::span<const double> amount, std::size_t species);

/// Of layers that are cut on the way: for arrangements in which sizes change place. height: (N) of the places [m].
Composition layer_composition(std::span<const double> height, std::span<const double> radius, const Layers& layers,
                              std::span<const std::int32_t> label, std::span<const double> amount, std::size_t species);

/// (species) variance of a species' share over the compartments, weighted by their amounts:
///   s^2 = sum_l W_l (c_l - P)^2 / sum_l W_l,  c_l share in compartment l, W_l its amount, P share of the whole bed.
std::vector<double> variance_by_species(const Composition& composition);

/// Shannon's entropy of the composition over that of the whole bed: 1 where every compartment is composed as the bed,
/// 0 where each holds one species; 0 also for a bed of one species.
///   H / H_0,  H = - sum_l W_l / W sum_s c_ls ln c_ls,  H_0 = - sum_s P_s ln P_s.
double mixing_entropy(const Composition& composition);

/// (compartments * species) variances of c_l - P under random mixing; w_i amount of particle i in the compartment, v_i
/// its whole amount, V = sum v.
///
/// Amounts independent of type: labels permuted at random among the N particles, n of the species, p = n/N. Exact:
///   var = p (1 - p) N/(N - 1) sum_i (w_i/W - v_i/V)^2.
/// For equal spheres this is p (1 - p)/n_eff (N - n_eff)/(N - 1) with n_eff = (sum w)^2 / sum w^2: Lacey's
/// p (1 - p)/n (J. Appl. Chem. 4 (1954) 257) with the correction for a finite population and for cut particles.
///
/// Amounts linked to type (Amounts::linked): labels cannot change places without them. A compartment is then a random
/// sample of the amount W of the mixture; with x_i = 1 for the species, to first order (ratio estimate, Cochran,
/// Sampling Techniques (1977), ch. 6):
///   var = N/(N - 1) sum_i v_i^2 (x_i - P)^2 / V (k/W - 1/V),  k = sum_i (w_i/W) (w_i/v_i) for the cut particles;
/// for two sizes without cutting P (1 - P) ((1 - P) v_1 + P v_2)/W (Stange, Chem.-Ing.-Tech. 26 (1954) 331).
/// Exact for equal spheres.
std::vector<double> random_variance(const Division& division, const SpeciesList& list, const Amounts& amounts,
                                    const Composition& composition);

/// Of s^2 summed over the species: the mean of the random variances, weighted as in s^2.
double expected_variance(const std::vector<double>& random_variance, const Composition& composition);

}  // namespace packstone::analysis
