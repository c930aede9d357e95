// Who counts as a neighbour for the bond-orientational order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/options.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// Neighbours of every particle, as ranges in one array.
struct Bonds {
  std::vector<std::size_t> begin;        ///< (N + 1)
  std::vector<std::uint32_t> neighbour;  ///< rows

  std::span<const std::uint32_t> of(std::size_t row) const {
    return std::span(neighbour).subspan(begin[row], begin[row + 1] - begin[row]);
  }
};

/// All others whose centres are nearer than factor times the sum of the radii, over the nearest periodic image;
/// centres at the same place are no neighbours, since nothing points from one to the other.
Bonds bonds_within(const Snapshot& snapshot, double factor);

/// The nearest others by distance of centres, so many or all there are; equally far ones by row.
Bonds nearest_bonds(const Snapshot& snapshot, std::size_t count);

/// The one or the other, as the options say.
Bonds chosen_bonds(const Snapshot& snapshot, const Options& options);

}  // namespace packstone::analysis
