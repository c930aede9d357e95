// Groups of particles by their size.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace packstone::analysis {

/// Numbers of groups, and how many particles each has.
struct GroupRanks {
  std::vector<std::uint32_t> of_particle;  ///< (N) 0 is the largest group, equal ones by their lowest id
  std::vector<std::uint32_t> size;         ///< by number
};

/// label: (N) any number below N, the same for all of a group; id: (N).
GroupRanks group_ranks(std::span<const std::uint32_t> label, std::span<const std::int64_t> id);

}  // namespace packstone::analysis
