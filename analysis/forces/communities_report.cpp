// Measure "communities": parts of the packing within which the contacts carry more than the mean.
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "analysis/forces/communities.hpp"
#include "analysis/forces/force_network.hpp"
#include "analysis/measures.hpp"

namespace packstone::analysis {

namespace {

struct CommunityQuantities {
  explicit CommunityQuantities(double gamma) {
    modularity.definition = fmt::format(
        "sum over contacts inside communities of (w - gamma <w>) over the sum of w over all contacts between "
        "particles; "
        "w the normal force, 0 where it pulls, gamma = {:g}: geographic null model of Bassett et al., Soft Matter 11 "
        "(2015) 2731; communities by greedy local moves and mergers",
        gamma);
  }

  Quantity modularity{.key = "modularity", .label = "modularity of the forces"};
  Quantity count{.key = "count", .label = "communities", .definition = "communities of two particles or more"};
  Quantity mean{.key = "mean_size",
                .label = "mean community size",
                .definition = "particles a community, of communities of two particles or more"};
  Quantity largest{.key = "largest", .label = "largest community", .definition = "particles of the largest community"};
  Quantity single{.key = "single_share",
                  .label = "share of particles in no community",
                  .definition = "particles that are a community by themselves over all particles"};

  std::vector<Quantity*> all() { return {&modularity, &count, &mean, &largest, &single}; }
};

std::vector<WeightedEdge> pressing_edges(const Snapshot& snapshot, const ForceNetwork& network) {
  std::vector<WeightedEdge> edges;
  for (std::size_t k = 0; k < network.size(); ++k) {
    const ForceContact& contact = network.contacts[k];
    if (contact.at_wall()) continue;
    edges.push_back({contact.first, contact.second, std::max(normal_force(*snapshot.contacts, k), 0.0)});
  }
  return edges;
}

/// Particles of every community.
std::vector<std::uint32_t> sizes_of(const std::vector<std::uint32_t>& label) {
  std::vector<std::uint32_t> size(*std::max_element(label.begin(), label.end()) + 1, 0);
  for (const auto l : label) ++size[l];
  return size;
}

Table size_table(const std::vector<std::uint32_t>& sizes) {
  Table table{.key = "sizes",
              .caption = "Communities by the number of their particles, single particles included",
              .columns = {{"size", "", ColumnFormat::integer}, {"communities", "", ColumnFormat::integer}}};
  std::map<std::uint32_t, std::size_t> count;
  for (const auto size : sizes) ++count[size];
  for (const auto& [size, n] : count) table.rows.push_back({static_cast<double>(size), static_cast<double>(n)});
  return table;
}

/// Largest community first, equal ones by their lowest id.
Table member_table(const Snapshot& snapshot, const std::vector<std::uint32_t>& label,
                   const std::vector<std::uint32_t>& sizes) {
  Table table{.key = "members",
              .caption =
                  "Particles by id, and the number of the community of each: 0 is the largest; equal ones by "
                  "their lowest id",
              .columns = {{"id", "", ColumnFormat::integer}, {"community", "", ColumnFormat::integer}}};
  std::vector<std::int64_t> lowest(sizes.size(), std::numeric_limits<std::int64_t>::max());
  for (std::size_t i = 0; i < label.size(); ++i) lowest[label[i]] = std::min(lowest[label[i]], snapshot.id[i]);
  std::vector<std::uint32_t> order(sizes.size()), rank(sizes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return sizes[a] != sizes[b] ? sizes[a] > sizes[b] : lowest[a] < lowest[b]; });
  for (std::uint32_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
  std::vector<std::uint32_t> row(label.size());
  std::iota(row.begin(), row.end(), 0u);
  std::sort(row.begin(), row.end(), [&](auto a, auto b) { return snapshot.id[a] < snapshot.id[b]; });
  for (const auto i : row) {
    table.rows.push_back({static_cast<double>(snapshot.id[i]), static_cast<double>(rank[label[i]])});
  }
  return table;
}

/// Why there is nothing to divide; empty where there is.
std::string reason_against(const std::vector<WeightedEdge>& edges, const ForceNetwork& network) {
  if (!network.missing.empty()) return network.missing;
  const bool pressed = std::any_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.weight > 0; });
  return pressed ? "" : "no particles press on each other";
}

}  // namespace

MeasureResult measure_communities(const Snapshot& snapshot, const Context& context) {
  const double gamma = context.options.forces.resolution;
  CommunityQuantities q(gamma);
  const ForceNetwork network = force_network(snapshot);
  const auto edges = pressing_edges(snapshot, network);
  std::vector<std::uint32_t> label, sizes;
  if (const std::string reason = reason_against(edges, network); !reason.empty()) {
    for (Quantity* each : q.all()) *each = not_applicable(*each, reason);
  } else {
    label = communities(edges, snapshot.size(), gamma);
    sizes = sizes_of(label);
    const double particles = static_cast<double>(label.size());
    const double single = static_cast<double>(std::count(sizes.begin(), sizes.end(), 1u));
    const double several = static_cast<double>(sizes.size()) - single;
    q.modularity.value = geographic_modularity(edges, label, gamma);
    q.count.value = several;
    q.largest.value = *std::max_element(sizes.begin(), sizes.end());
    q.single.value = single / particles;
    if (several > 0) {
      q.mean.value = (particles - single) / several;
    } else {
      q.mean = not_applicable(q.mean, "no community of two particles or more");
    }
  }
  MeasureResult result{.name = "communities"};
  for (Quantity* each : q.all()) result.quantities.push_back(*each);
  result.tables = {size_table(sizes), member_table(snapshot, label, sizes)};
  return result;
}

}  // namespace packstone::analysis
