// Measure "communities": parts of the packing within which the contacts carry more than the mean.
#include <algorithm>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "analysis/forces/communities.hpp"
#include "analysis/forces/force_network.hpp"
#include "analysis/group_ranks.hpp"
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

Table size_table(const std::vector<std::uint32_t>& sizes) {
  Table table{.key = "sizes",
              .caption = "Communities by the number of their particles, single particles included",
              .columns = {{"size", "", ColumnFormat::integer}, {"communities", "", ColumnFormat::integer}}};
  std::map<std::uint32_t, std::size_t> count;
  for (const auto size : sizes) ++count[size];
  for (const auto& [size, n] : count) table.rows.push_back({static_cast<double>(size), static_cast<double>(n)});
  return table;
}

/// By id.
Table member_table(const Snapshot& snapshot, const GroupRanks& ranks) {
  Table table{.key = "members",
              .caption =
                  "Particles by id, and the number of the community of each: 0 is the largest; equal ones by "
                  "their lowest id",
              .columns = {{"id", "", ColumnFormat::integer}, {"community", "", ColumnFormat::integer}}};
  std::vector<std::uint32_t> row(ranks.of_particle.size());
  std::iota(row.begin(), row.end(), 0u);
  std::sort(row.begin(), row.end(), [&](auto a, auto b) { return snapshot.id[a] < snapshot.id[b]; });
  for (const auto i : row) {
    table.rows.push_back({static_cast<double>(snapshot.id[i]), static_cast<double>(ranks.of_particle[i])});
  }
  return table;
}

/// What the forces divide the packing into.
struct Division {
  std::string missing;  ///< why there is nothing to divide; empty where there is
  std::vector<WeightedEdge> edges;
  std::vector<std::uint32_t> label;  ///< (N)
  GroupRanks ranks;
};

Division divided(const Snapshot& snapshot, double gamma) {
  const ForceNetwork network = force_network(snapshot);
  Division division{network.missing, pressing_edges(snapshot, network), {}, {}};
  const bool pressed =
      std::any_of(division.edges.begin(), division.edges.end(), [](const auto& edge) { return edge.weight > 0; });
  if (division.missing.empty() && !pressed) division.missing = "no particles press on each other";
  if (!division.missing.empty()) return division;
  division.label = communities(division.edges, snapshot.size(), gamma);
  division.ranks = group_ranks(division.label, snapshot.id);
  return division;
}

}  // namespace

MeasureResult measure_communities(const Snapshot& snapshot, const Context& context) {
  const double gamma = context.options.forces.resolution;
  CommunityQuantities q(gamma);
  const Division division = divided(snapshot, gamma);
  const auto& sizes = division.ranks.size;
  if (!division.missing.empty()) {
    for (Quantity* each : q.all()) *each = not_applicable(*each, division.missing);
  } else {
    const double particles = static_cast<double>(snapshot.size());
    const double single = static_cast<double>(std::count(sizes.begin(), sizes.end(), 1u));
    const double several = static_cast<double>(sizes.size()) - single;
    q.modularity.value = geographic_modularity(division.edges, division.label, gamma);
    q.count.value = several;
    q.largest.value = sizes.front();
    q.single.value = single / particles;
    if (several > 0) {
      q.mean.value = (particles - single) / several;
    } else {
      q.mean = not_applicable(q.mean, "no community of two particles or more");
    }
  }
  MeasureResult result{.name = "communities"};
  for (Quantity* each : q.all()) result.quantities.push_back(*each);
  result.tables = {size_table(sizes), member_table(snapshot, division.ranks)};
  return result;
}

std::vector<ParticleField> community_fields(const Snapshot& snapshot, const Context& context) {
  const Division division = divided(snapshot, context.options.forces.resolution);
  return {{.name = "community",
           .definition =
               "number of its community of forces, as in table members: 0 is the largest, equal ones by their "
               "lowest id",
           .values = as_values(division.ranks.of_particle),
           .missing = division.missing}};
}

}  // namespace packstone::analysis
