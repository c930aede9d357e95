#include "analysis/clusters/cluster_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

std::uint8_t lower_end(int axis) { return static_cast<std::uint8_t>(1u << (2 * axis)); }
std::uint8_t upper_end(int axis) { return static_cast<std::uint8_t>(2u << (2 * axis)); }

/// Ends of the packing along an axis, as coordinates [m].
std::pair<double, double> ends_along(const Snapshot& snapshot, const Context& context, int axis) {
  const BedFrame& frame = context.frame;
  if (axis == frame.axis && context.bed.height > 0) {
    const double top = frame.floor + frame.sign * context.bed.height;
    return std::minmax({frame.floor, top});
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    low = std::min(low, snapshot.position[i][axis] - snapshot.radius[i]);
    high = std::max(high, snapshot.position[i][axis] + snapshot.radius[i]);
  }
  return {low, high};
}

/// What is summed up over a cluster's spheres.
struct Moments {
  double mass = 0;
  Vec3 first = Vec3::Zero();
  double second = 0;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;

  void add(const Vec3& x, double radius, double m) {
    mass += m;
    first += m * x;
    second += m * x.squaredNorm();
    low = low.cwiseMin(x - Vec3::Constant(radius));
    high = high.cwiseMax(x + Vec3::Constant(radius));
  }
};

}  // namespace

ImageSets joined_clusters(const ClusterLinks& links, std::span<const std::int32_t> label, std::size_t particles) {
  ImageSets sets(particles);
  for (const ClusterLink& link : links.links) {
    if (!label.empty() && label[link.first] != label[link.second]) continue;
    sets.join(link.first, link.second, {link.image[0], link.image[1], link.image[2]});
  }
  return sets;
}

std::vector<std::uint8_t> ends_of_particles(const Snapshot& snapshot, const Context& context) {
  std::vector<std::uint8_t> ends(snapshot.size(), 0);
  const double near = context.mean_radius;
  for (int axis = 0; axis < 3; ++axis) {
    if (snapshot.domain.periodic[axis]) continue;
    const auto [low, high] = ends_along(snapshot, context, axis);
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
      const double x = snapshot.position[i][axis], r = snapshot.radius[i];
      if (x - r < low + near) ends[i] |= lower_end(axis);
      if (x + r > high - near) ends[i] |= upper_end(axis);
    }
  }
  return ends;
}

Percolation::Percolation(ImageSets& sets, std::span<const std::uint8_t> ends, const Domain& domain)
    : sets_(sets), domain_(domain), ends_(ends.size(), 0) {
  for (std::uint32_t i = 0; i < ends.size(); ++i) ends_[sets.find(i).root] |= ends[i];
}

bool Percolation::along(std::uint32_t root, int axis) const {
  if (domain_.periodic[axis]) return sets_.wraps(root, axis);
  const std::uint8_t both = lower_end(axis) | upper_end(axis);
  return (ends_[root] & both) == both;
}

std::vector<ClusterShape> largest_clusters(const Snapshot& snapshot, ImageSets& sets, std::size_t most) {
  std::vector<ClusterShape> shapes;
  std::vector<char> seen(snapshot.size(), 0);
  for (std::uint32_t i = 0; i < snapshot.size(); ++i) {
    const std::uint32_t root = sets.find(i).root;
    if (seen[root]) continue;
    seen[root] = 1;
    shapes.push_back({.root = root, .size = sets.size(root), .gyration_radius = std::nullopt});
  }
  const auto larger = [](const ClusterShape& a, const ClusterShape& b) { return a.size > b.size; };
  std::stable_sort(shapes.begin(), shapes.end(), larger);  // they stand by lowest row
  shapes.resize(std::min(shapes.size(), most));

  std::unordered_map<std::uint32_t, Moments> moments;
  for (const ClusterShape& shape : shapes) moments.emplace(shape.root, Moments{});
  const Vec3 period = snapshot.domain.size();
  for (std::uint32_t i = 0; i < snapshot.size(); ++i) {
    const ImageSets::Member member = sets.find(i);
    const auto found = moments.find(member.root);
    if (found == moments.end()) continue;
    // From the root, so that squares of large coordinates do not swallow small clusters.
    Vec3 x = snapshot.position[i] - snapshot.position[member.root];
    for (int k = 0; k < 3; ++k) x[k] += period[k] * member.image[k];
    found->second.add(x, snapshot.radius[i], sphere_volume(snapshot.radius[i]));
  }
  for (ClusterShape& shape : shapes) {
    const Moments& sum = moments.at(shape.root);
    shape.extent = sum.high - sum.low;
    const bool endless = sets.wraps(shape.root, 0) || sets.wraps(shape.root, 1) || sets.wraps(shape.root, 2);
    if (endless || !(sum.mass > 0)) continue;
    const double squared = sum.second / sum.mass - (sum.first / sum.mass).squaredNorm();
    shape.gyration_radius = std::sqrt(std::max(0.0, squared));
  }
  return shapes;
}

}  // namespace packstone::analysis
