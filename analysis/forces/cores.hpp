// The k-cores of a network.
#pragma once

#include <vector>

#include "analysis/adjacency.hpp"

namespace packstone::analysis {

/// (N) core number of every node: the largest k such that it belongs to a part of the network in which every node has
/// k neighbours or more. O(N + pairs).
/// Source: Seidman, Social Networks 5 (1983) 269; Batagelj, Zaversnik, Adv. Data Anal. Classif. 5 (2011) 129.
std::vector<int> core_numbers(const Adjacency& near);

}  // namespace packstone::analysis
