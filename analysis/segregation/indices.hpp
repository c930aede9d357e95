// The indices of mixing of a division of the bed, as quantities beside what random mixing gives.
#pragma once

#include <string>

#include "analysis/result.hpp"
#include "analysis/segregation/arrangement.hpp"

namespace packstone::analysis {

/// Lacey's index of a variance s^2 summed over the species: (s0^2 - s^2) / (s0^2 - sr^2). No value where random mixing
/// cannot be told from separation.
struct LaceyScale {
  double separated = 0;  ///< s0^2
  double random = 0;     ///< sr^2

  bool exists() const;
  double contrast() const { return separated - random; }
  double operator()(double variance) const { return (separated - variance) / contrast(); }
};

/// sr^2 is the exact expectation where types can change places, else the mean over the random arrangements.
LaceyScale lacey_scale(const MixedBed& bed, const Division& division, const RandomReference& random_variance);

/// Of factor * x + offset.
RandomReference transformed(const RandomReference& reference, double factor, double offset = 0);

/// Appends the quantity with its random value and z-score (add_with_reference), and the band that holds 95 % of the
/// random values (key_random_low, key_random_high; no value from fewer than 40 arrangements).
void add_with_band(MeasureResult& result, const Quantity& quantity, const RandomReference& reference,
                   const std::string& model);

/// The same five keys without any value.
void add_missing(MeasureResult& result, const Quantity& quantity, const std::string& reason);

/// The indices of the bed's layers, rings or cells: lacey, intensity, rsd and entropy, with the part's prefix.
void add_part_indices(MeasureResult& result, const MixedBed& bed, const MixingNumbers& numbers, Part part);

/// What the compartments of a part are, for definitions and captions.
std::string compartments_text(const MixedBed& bed, Part part);

}  // namespace packstone::analysis
