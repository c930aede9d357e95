// The particles as found, and as they might lie instead: at random, or separated.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/relabelling.hpp"
#include "analysis/segregation/mixed_bed.hpp"

namespace packstone::analysis {

/// Numbers of the whole bed.
enum WholeNumber : std::size_t {
  height_difference,  ///< of the highest and the lowest centre of a type [m]
  centre_distance,    ///< of the centres farthest apart [m]
  unlike_contacts,    ///< share of all contacts between particles; 0 without contacts
  whole_count
};

/// Numbers of one division of the bed; all 0 where it is missing.
enum DivisionNumber : std::size_t {
  variance,            ///< s^2 summed over the species
  relative_deviation,  ///< of the share of the scarcest species, over that share
  entropy,             ///< mixing_entropy
  division_count
};

/// Where a number stands among all of an arrangement.
inline std::size_t index_of(WholeNumber number) { return number; }
inline std::size_t index_of_division(std::size_t division, DivisionNumber number) {
  const std::size_t first = whole_count + division * division_count;
  return first + number;
}
inline std::size_t index_of(Part part, DivisionNumber number) { return index_of_division(part, number); }
inline std::size_t index_of_scale(std::size_t scale, DivisionNumber number) {
  return index_of_division(part_count + scale, number);
}

/// The numbers of the bed, and what they would be.
struct MixingNumbers {
  std::vector<double> found;
  std::vector<double> separated;        ///< types one on another along the longest side of the bed's box
  std::vector<RandomReference> random;  ///< permutation_count(N) random arrangements
  std::string model;                    ///< one sentence: what "random" is
};

/// Particles change places at random. Where amounts are linked to types (Amounts::linked) a particle takes its size and
/// its amount along, and the layers are cut anew; else only the types change places. So a random bed has the same
/// places, and compartments by centres the same number of particles. About 40 bytes a particle and
/// thread.
MixingNumbers mixing_numbers(const MixedBed& bed);

}  // namespace packstone::analysis
