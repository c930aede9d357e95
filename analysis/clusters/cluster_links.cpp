#include "analysis/clusters/cluster_links.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/forces/force_network.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

/// The stored contacts between particles that stand behind the network's pairs, in their order.
std::vector<double> normal_forces(const Contacts& contacts) {
  std::vector<double> forces;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (contacts.overlap[k] > 0 && contacts.second[k] >= 0) forces.push_back(normal_force(contacts, k));
  }
  return forces;
}

std::vector<NearPair> strong_pairs(const Snapshot& snapshot, const Context& context) {
  const std::vector<double> forces = normal_forces(*snapshot.contacts);
  double mean = 0;
  for (const double f : forces) mean += f / static_cast<double>(forces.size());
  std::vector<NearPair> strong;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (forces[k] > context.options.clusters.least_force * mean) strong.push_back(context.contacts.pairs[k]);
  }
  return strong;
}

}  // namespace

ClusterLinks cluster_links(const Snapshot& snapshot, const Context& context) {
  const ClusterOptions& options = context.options.clusters;
  if (options.gap > 0 && options.least_force > 0) {
    throw InputError("clusters by distance and by force at once; choose a gap or a least force");
  }
  ClusterLinks result;
  result.rule = "in contact";
  std::vector<NearPair> chosen;
  const std::vector<NearPair>* pairs = &context.contacts.pairs;
  if (options.gap > 0) {
    result.rule = fmt::format("whose surfaces are nearer than {:g} m", options.gap);
    chosen = near_pairs(snapshot.position, snapshot.radius, snapshot.domain, options.gap);
    pairs = &chosen;
  } else if (options.least_force > 0) {
    result.rule =
        fmt::format("that press on each other by more than {:g} times the mean normal force between particles",
                    options.least_force);
    if (!snapshot.contacts) {
      result.unavailable = "the snapshot holds no contact forces";
      return result;
    }
    chosen = strong_pairs(snapshot, context);
    pairs = &chosen;
  }
  const Vec3 period = snapshot.domain.size();
  result.links.reserve(pairs->size());
  for (const NearPair& pair : *pairs) {
    const Vec3 apart = snapshot.position[pair.second] - snapshot.position[pair.first];
    ClusterLink link{pair.first, pair.second, {0, 0, 0}};
    for (int k = 0; k < 3; ++k) {
      if (snapshot.domain.periodic[k]) link.image[k] = static_cast<std::int8_t>(-std::lround(apart[k] / period[k]));
    }
    result.links.push_back(link);
  }
  return result;
}

}  // namespace packstone::analysis
