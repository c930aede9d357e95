// Force chains: files of particles that carry more than the mean stress along one line.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/forces/force_network.hpp"

namespace packstone::analysis {

/// A contact along which a chain runs.
struct ChainLink {
  std::uint32_t chain;    ///< index into ForceChains::length
  std::uint32_t first;    ///< row
  std::uint32_t second;   ///< row
  std::uint32_t contact;  ///< index into ForceNetwork::contacts
};

inline constexpr std::uint32_t no_chain = std::numeric_limits<std::uint32_t>::max();

struct ForceChains {
  std::vector<std::uint32_t> length;       ///< particles of each chain, three or more
  std::vector<ChainLink> links;            ///< by chain, then in the order of the contacts
  std::vector<std::uint32_t> of_particle;  ///< (N) index into length; no_chain
  std::size_t particles = 0;               ///< in chains
  std::size_t branch_points = 0;           ///< particles of chains with three links or more
};

/// A particle can be in a chain when the largest (most compressive) principal stress of its own stress tensor
/// (particle_force_moments over 4/3 pi r^3) is above options.chain_threshold times the mean over all particles with a
/// stored contact. Two such particles that press on each other are linked when the line of their centres is within
/// options.chain_angle of both particles' directions of largest principal stress. Chains are the connected sets of
/// linked particles, three or more; numbered by their lowest particle id. Particles of radius 0 have no stress.
/// Source: Peters, Muthuswamy, Wibowo, Tordesillas, Phys. Rev. E 72 (2005) 041307.
ForceChains force_chains(const Snapshot& snapshot, const ForceNetwork& network, const ForceOptions& options);

}  // namespace packstone::analysis
