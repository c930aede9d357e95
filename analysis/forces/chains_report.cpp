// Force chains as quantities and tables.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "analysis/forces/force_chains.hpp"
#include "analysis/forces/parts.hpp"
#include "analysis/forces/stress.hpp"

namespace packstone::analysis {

namespace {

constexpr double direction_bin = 10;  // degrees
constexpr int direction_bins = 9;

struct ChainQuantities {
  explicit ChainQuantities(const ForceOptions& options) {
    count.definition = fmt::format(
        "chains of three particles or more, after Peters et al., Phys. Rev. E 72 (2005) 041307: particles whose "
        "largest "
        "principal stress is above {:g} times the mean over all particles with a contact, linked where they press on "
        "each other and the line of their centres is within {:g} degrees of the direction of that stress in both",
        options.chain_threshold, options.chain_angle);
  }

  Quantity count{.key = "chain_count", .label = "force chains"};
  Quantity mean{.key = "chain_length_mean", .label = "mean length of chains", .definition = "particles a chain"};
  Quantity longest{
      .key = "chain_length_max", .label = "longest chain", .definition = "particles of the longest force chain"};
  Quantity share{.key = "chain_particle_share",
                 .label = "share of particles in chains",
                 .definition = "particles in force chains over all particles"};
  Quantity branches{.key = "chain_branch_points",
                    .label = "branching points of chains",
                    .definition = "particles of force chains that have three links or more"};
  Quantity angle{.key = "chain_angle_mean",
                 .label = "mean angle of chains to the vertical",
                 .unit = "degrees",
                 .definition =
                     "mean over all links of force chains of the angle between the line of centres and the vertical, 0 "
                     "to 90; 57.3 for directions at random"};

  std::vector<Quantity*> all() { return {&count, &mean, &longest, &share, &branches, &angle}; }
};

Table length_table(const ForceChains& chains) {
  Table table{.key = "chain_lengths",
              .caption = "Force chains by length, the number of their particles",
              .columns = {{"length", "", ColumnFormat::integer}, {"chains", "", ColumnFormat::integer}}};
  std::map<std::uint32_t, std::size_t> count;
  for (const std::uint32_t length : chains.length) ++count[length];
  for (const auto& [length, n] : count) {
    table.rows.push_back({static_cast<double>(length), static_cast<double>(n)});
  }
  return table;
}

/// Links by angle, beside what directions at random would give.
Table direction_table(const std::vector<double>& angles) {
  Table table{
      .key = "chain_directions",
      .caption =
          "Links of force chains by their angle to the vertical; relative: share over that of directions at "
          "random, cos(lower) - cos(upper)",
      .columns = {{"lower", "degrees"}, {"upper", "degrees"}, {"links", "", ColumnFormat::integer}, {"relative"}}};
  if (angles.empty()) return table;
  std::vector<double> count(direction_bins, 0.0);
  for (const double angle : angles)
    ++count[std::min(static_cast<std::size_t>(angle / direction_bin), count.size() - 1)];
  const auto cosine = [](double degrees) { return std::cos(degrees * std::numbers::pi / 180); };
  for (int k = 0; k < direction_bins; ++k) {
    const double lower = direction_bin * k, upper = lower + direction_bin, links = count[static_cast<std::size_t>(k)];
    const double share = links / static_cast<double>(angles.size());
    table.rows.push_back({lower, upper, links, share / (cosine(lower) - cosine(upper))});
  }
  return table;
}

Table link_table(const Snapshot& snapshot, const ForceChains& chains) {
  Table table{.key = "chain_links",
              .caption =
                  "Links of force chains: number of the chain (by its lowest particle id), ids of the two particles, "
                  "normal force",
              .columns = {{"chain", "", ColumnFormat::integer},
                          {"first", "", ColumnFormat::integer},
                          {"second", "", ColumnFormat::integer},
                          {"force", "N"}}};
  table.rows.reserve(chains.links.size());
  for (const ChainLink& link : chains.links) {
    table.rows.push_back({static_cast<double>(link.chain), static_cast<double>(snapshot.id[link.first]),
                          static_cast<double>(snapshot.id[link.second]),
                          normal_force(*snapshot.contacts, link.contact)});
  }
  return table;
}

}  // namespace

void add_force_chains(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                      const ForceNetwork& network) {
  ChainQuantities q(context.options.forces);
  ForceChains chains;
  std::vector<double> angles;
  if (!network.missing.empty()) {
    for (Quantity* each : q.all()) *each = not_applicable(*each, network.missing);
  } else {
    chains = force_chains(snapshot, network, context.options.forces);
    q.count.value = static_cast<double>(chains.length.size());
    q.share.value = static_cast<double>(chains.particles) / static_cast<double>(snapshot.size());
    q.branches.value = static_cast<double>(chains.branch_points);
    double sum = 0;
    for (const ChainLink& link : chains.links) {
      angles.push_back(angle_to_vertical(network.contacts[link.contact].branch, context.frame));
      sum += angles.back();
    }
    if (chains.length.empty()) {
      for (Quantity* each : {&q.mean, &q.longest, &q.angle}) *each = not_applicable(*each, "no force chains");
    } else {
      q.mean.value = static_cast<double>(chains.particles) / *q.count.value;
      q.longest.value = *std::max_element(chains.length.begin(), chains.length.end());
      q.angle.value = sum / static_cast<double>(angles.size());
    }
  }
  for (Quantity* each : q.all()) result.quantities.push_back(*each);
  result.tables.push_back(length_table(chains));
  result.tables.push_back(direction_table(angles));
  result.tables.push_back(link_table(snapshot, chains));
}

}  // namespace packstone::analysis
