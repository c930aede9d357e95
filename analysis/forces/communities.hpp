// Communities of a weighted network: parts within which particles press on each other harder than on average.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace packstone::analysis {

/// An edge of an undirected network, listed once.
struct WeightedEdge {
  std::uint32_t first;
  std::uint32_t second;
  double weight;
};

/// Modularity with the geographic null model,
///   Q = sum over edges inside communities of (w - gamma <w>) / sum over all edges of w,
/// <w> the mean weight of an edge: a community counts by what its contacts carry beyond gamma times the mean, and
/// nodes that do not touch expect nothing of each other. 1 - gamma for one community of all. The sum of weights must
/// be above 0. label: (nodes).
/// Source: Bassett, Owens, Porter, Manning, Daniels, Soft Matter 11 (2015) 2731, there without the total
/// weight.
double geographic_modularity(std::span<const WeightedEdge> edges, std::span<const std::uint32_t> label, double gamma);

/// A partition whose modularity no move of a node and no merger of two communities improves: local moves, then moves
/// of whole communities, repeated (Blondel et al., J. Stat. Mech. (2008) P10008); communities are connected. Nodes are
/// visited in order, so that the result is always the same. Labels (nodes): 0, 1, ... in the order of their first
/// nodes. The sum of weights must be above 0.
std::vector<std::uint32_t> communities(std::span<const WeightedEdge> edges, std::size_t nodes, double gamma);

}  // namespace packstone::analysis
