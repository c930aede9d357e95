// Beds of several types for the mixing indices.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/analysis/fixtures.hpp"

namespace packstone::fixtures {

/// A closed cubic bed divided exactly: layers of one particle, cells of 2 x 2 x 2.
inline analysis::MeasureResult indices_of(const Snapshot& s, analysis::Options options = {}) {
  options.segregation_layer = 2;
  options.segregation_cell = 4;
  return measured(s, "segregation", options);
}

inline Snapshot closed_bed(int nx, int ny, int nz) { return cubic_bed(nx, ny, nz, {false, false, false}); }

/// Types in order of the rows, of the counts given, at random.
inline void label_at_random(Snapshot& s, const std::vector<int>& counts, std::uint64_t seed) {
  std::vector<int> types;
  for (std::size_t k = 0; k < counts.size(); ++k) types.insert(types.end(), counts[k], static_cast<int>(k));
  Random random(seed, RandomStream::filling_order, 0);
  shuffle(types, random);
  s.type = types;
}

/// How many standard deviations random numbers may be off.
inline constexpr double sigmas = 4;

}  // namespace packstone::fixtures
