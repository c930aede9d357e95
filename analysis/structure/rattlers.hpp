// Particles that nothing holds in place.
#pragma once

#include <vector>

#include "analysis/adjacency.hpp"

namespace packstone::analysis {

/// Fewest contacts that can hold a sphere in place: d + 1 in d = 3 dimensions, without friction.
inline constexpr int fewest_to_be_stable = 4;

/// (N) 1 for the particles taken away when those with fewer contacts than fewest_to_be_stable are removed until none is
/// left. near: contacts between particles; contacts: (N) number of contacts of each, with boundaries too.
std::vector<char> rattlers(const Adjacency& near, const std::vector<int>& contacts);

}  // namespace packstone::analysis
