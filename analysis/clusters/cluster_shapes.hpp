// How far clusters reach.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/clusters/cluster_links.hpp"
#include "analysis/clusters/image_sets.hpp"
#include "analysis/context.hpp"

namespace packstone::analysis {

/// Joins what the links and labels allow; any label where label is empty.
ImageSets joined_clusters(const ClusterLinks& links, std::span<const std::int32_t> label, std::size_t particles);

/// (N) a bit for each end of the packing that a particle is at: 1 << 2 k for the lower end along axis k, 1 << (2 k + 1)
/// for the upper. At an end: less than a mean radius between the sphere's surface and the outermost sphere's; along
/// up the ends are the floor and bed_height. Periodic axes have none.
std::vector<std::uint8_t> ends_of_particles(const Snapshot& snapshot, const Context& context);

/// Along which axes clusters reach right through the packing.
class Percolation {
 public:
  Percolation(ImageSets& sets, std::span<const std::uint8_t> ends, const Domain& domain);

  /// Along a periodic axis: the cluster meets its own image; else it is at both ends. root: of the cluster.
  bool along(std::uint32_t root, int axis) const;
  bool along_any(std::uint32_t root) const { return along(root, 0) || along(root, 1) || along(root, 2); }

 private:
  const ImageSets& sets_;
  Domain domain_;
  std::vector<std::uint8_t> ends_;  ///< of each root's cluster
};

struct ClusterShape {
  std::uint32_t root = 0;
  std::uint32_t size = 0;
  Vec3 extent = Vec3::Zero();  ///< of its spheres, unwrapped [m]
  /// sqrt(sum v |x - centre|^2 / sum v) of the centres, v the volume [m]; none where the cluster is endless.
  std::optional<double> gyration_radius;
};

/// Of the largest clusters, at most so many, by size and then by the lowest row.
std::vector<ClusterShape> largest_clusters(const Snapshot& snapshot, ImageSets& sets, std::size_t most);

}  // namespace packstone::analysis
