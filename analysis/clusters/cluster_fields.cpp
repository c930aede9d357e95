// The cluster of every particle.
#include "analysis/clusters/cluster_shapes.hpp"
#include "analysis/group_ranks.hpp"
#include "analysis/measures.hpp"
#include "analysis/species.hpp"

namespace packstone::analysis {

std::vector<ParticleField> cluster_fields(const Snapshot& snapshot, const Context& context) {
  const ClusterLinks links = cluster_links(snapshot, context);
  std::vector<ParticleField> fields = {{.name = "cluster",
                                        .definition = "number of its cluster of particles " + links.rule +
                                                      (context.options.clusters.any_type ? "" : " and of one type") +
                                                      "; 0 is the largest, equal ones by their lowest id"},
                                       {.name = "cluster_size", .definition = "particles of its cluster"}};
  if (!links.unavailable.empty()) return without_values(std::move(fields), links.unavailable);

  const SpeciesList list = species_of(snapshot);
  ImageSets sets = joined_clusters(
      links, context.options.clusters.any_type ? std::span<const std::int32_t>() : list.label, snapshot.size());
  std::vector<std::uint32_t> root;
  for (std::uint32_t i = 0; i < snapshot.size(); ++i) root.push_back(sets.find(i).root);
  const GroupRanks ranks = group_ranks(root, snapshot.id);
  for (const std::uint32_t rank : ranks.of_particle) {
    fields[0].values.push_back(rank);
    fields[1].values.push_back(ranks.size[rank]);
  }
  return fields;
}

}  // namespace packstone::analysis
