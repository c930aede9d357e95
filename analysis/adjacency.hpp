// Pairs seen from each particle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/neighbours.hpp"

namespace packstone::analysis {

/// Neighbours of every particle, as ranges in one array, in the order of the pairs.
struct Adjacency {
  std::vector<std::size_t> begin;        ///< (N + 1)
  std::vector<std::uint32_t> neighbour;  ///< (2 pairs) rows
  std::vector<std::uint32_t> pair;       ///< (2 pairs) index of the pair that each neighbour comes from

  std::span<const std::uint32_t> of(std::size_t row) const {
    return std::span(neighbour).subspan(begin[row], begin[row + 1] - begin[row]);
  }
  std::span<const std::uint32_t> pairs_of(std::size_t row) const {
    return std::span(pair).subspan(begin[row], begin[row + 1] - begin[row]);
  }
};

/// particles: N.
Adjacency adjacency(std::span<const NearPair> pairs, std::size_t particles);

}  // namespace packstone::analysis
