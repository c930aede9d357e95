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

/// Ordered pairs of a reference particle and another, both in the window W, counted by distance against what
/// independent uniform positions in W would give at all r, sides and all:
///   g = pairs |W| / (V_shell sum m_a N_b f_a f_b / F),
/// over (a, b) and (b, a), N_a - 1 for a = b; N particles of a type in W, m of them references. F(r) is the share of a
/// shell that lies in W, mean over W (exact: W's isotropised set covariance over |W|); f is the same as mean over the
/// references of a and over the particles of b (by random directions from each). So the density around the pairs that
/// can be seen at r enters instead of that of W, without which the error for a bounded W would far exceed the counting
/// error. Without sides f = F = 1 and g is the usual one.
/// Source: Stoyan, Stoyan, Scand. J. Stat. 27 (2000) 641 (intensity adapted to the distance).
/// Error, as if pairs were independent: g sqrt((1 + m/N)/pairs); a pair of two references counts twice.
///
/// label: (N) from 0; labels: how many (0: total only). range = bin * bins at most half of every side of the window,
/// else pairs are missed. Needs two particles in the window, else all is 0.
PairDistribution pair_distribution(const Snapshot& snapshot, const Window& window, std::span<const std::int32_t> label,
                                   std::size_t labels, double bin, std::size_t bins);

}  // namespace packstone::analysis
