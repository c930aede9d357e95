// Radial distribution function g_ab(r) by pair of types.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/structure/window.hpp"

namespace packstone::analysis {

/// One curve; bin k covers [k, k + 1) times the bin's width.
struct PairCurve {
  std::vector<double> g;      ///< (bins)
  std::vector<double> error;  ///< (bins) one standard error; 0 where no pair was found
};

struct PairDistribution {
  double bin = 0;  ///< width [m]
  std::size_t bins = 0;
  std::size_t particles = 0;            ///< in the window
  std::size_t references = 0;           ///< of them, drawn at random, around which pairs are counted
  PairCurve total = {};                 ///< whatever the types
  std::vector<PairCurve> partial = {};  ///< of labels a <= b: (0, 0), (0, 1), .., (1, 1), ..; none when not asked for
};

/// Every ordered pair of a reference particle i and another j in the window W, x = x_j - x_i, |x| in the bin, counts
/// with the weight 1/|W and W + x| (the translation correction: exact at all r for any homogeneous packing, Ohser,
/// Math. Operationsforsch. Stat. 14 (1983) 63; 1/|W| in a wholly periodic box):
///   g = |W|^2 sum(weights)/(V_shell n),  n = m_a N_b + m_b N_a, m_a (N_a - 1) for a = b,
/// with N particles and m references of a type in W. 1 on average for independent uniform positions. Error, as if pairs
/// were independent: g sqrt((1 + m/N) sum(weights^2))/sum(weights); a pair of two references counts twice.
///
/// label: (N) from 0; labels: how many (0: total only). range at most half of every side of the window, else pairs are
/// missed. Needs two particles in the window, else all is 0.
PairDistribution pair_distribution(const Snapshot& snapshot, const Window& window, std::span<const std::int32_t> label,
                                   std::size_t labels, double bin, std::size_t bins);

}  // namespace packstone::analysis
