// Which pairs of particles may join a cluster.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/context.hpp"

namespace packstone::analysis {

/// Two particles that are joined when they are of one type, or in any case (ClusterOptions::any_type).
struct ClusterLink {
  std::uint32_t first;
  std::uint32_t second;
  std::array<std::int8_t, 3> image;  ///< periods to add to the second's position to stand beside the first
};

struct ClusterLinks {
  std::vector<ClusterLink> links;
  std::string rule;         ///< what joins, for the definitions: "in contact", ...
  std::string unavailable;  ///< why there are none to be had; empty otherwise
};

/// Contacts; or, as the options say, pairs of spheres nearer than a gap, or contacts above a normal force.
/// Throws InputError when the options contradict each other.
ClusterLinks cluster_links(const Snapshot& snapshot, const Context& context);

}  // namespace packstone::analysis
