#include "analysis/structure/bonds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "analysis/point_grid.hpp"

namespace packstone::analysis {

namespace {

constexpr std::size_t block_size = 4096;
constexpr double search_growth = 1.5;  // of the distance, when it held too few

/// Lists of all particles from neighbours_of(row, list), which appends those of one; in parallel, put together in
/// order.
template <class NeighboursOf>
Bonds collected(std::size_t particles, NeighboursOf&& neighbours_of) {
  const std::size_t blocks = (particles + block_size - 1) / block_size;
  std::vector<std::vector<std::uint32_t>> lists(blocks);
  Bonds bonds;
  bonds.begin.assign(particles + 1, 0);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t i = b * block_size; i < std::min(particles, (b + 1) * block_size); ++i) {
      const std::size_t before = lists[b].size();
      neighbours_of(i, lists[b]);
      bonds.begin[i + 1] = lists[b].size() - before;
    }
  }
  std::partial_sum(bonds.begin.begin(), bonds.begin.end(), bonds.begin.begin());
  bonds.neighbour.reserve(bonds.begin.back());
  for (auto& list : lists) {
    bonds.neighbour.insert(bonds.neighbour.end(), list.begin(), list.end());
    list = {};
  }
  return bonds;
}

}  // namespace

Bonds bonds_within(const Snapshot& snapshot, double factor) {
  const auto levels = size_levels(snapshot.position, snapshot.radius, snapshot.domain);
  return collected(snapshot.size(), [&](std::size_t i, std::vector<std::uint32_t>& list) {
    for (const SizeLevel& level : levels) {
      const double reach = factor * (snapshot.radius[i] + level.largest);
      level.grid.for_each_within(snapshot.position[i], reach, [&](std::uint32_t j, const Vec3&, double squared) {
        const double limit = factor * (snapshot.radius[i] + snapshot.radius[j]);
        if (j != i && squared > 0 && squared < limit * limit) list.push_back(j);
      });
    }
  });
}

Bonds nearest_bonds(const Snapshot& snapshot, std::size_t count) {
  const std::size_t particles = snapshot.size();
  std::vector<std::uint32_t> rows(particles);
  std::iota(rows.begin(), rows.end(), 0u);
  const double volume_each = snapshot.domain.size().prod() / static_cast<double>(std::max<std::size_t>(particles, 1));
  const double start = std::cbrt(volume_each);
  const PointGrid grid(snapshot.position, rows, snapshot.domain, start);
  return collected(particles, [&](std::size_t i, std::vector<std::uint32_t>& list) {
    std::vector<std::pair<double, std::uint32_t>> near;
    const double farthest = grid.farthest(snapshot.position[i]);
    for (double reach = start;; reach *= search_growth) {
      near.clear();
      grid.for_each_within(snapshot.position[i], reach, [&](std::uint32_t j, const Vec3&, double squared) {
        if (j != i && squared > 0) near.emplace_back(squared, j);
      });
      if (near.size() >= count || reach > farthest) break;
    }
    const std::size_t found = std::min(count, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(found), near.end());
    for (std::size_t k = 0; k < found; ++k) list.push_back(near[k].second);
  });
}

Bonds chosen_bonds(const Snapshot& snapshot, const Options& options) {
  return options.bond_neighbours > 0 ? nearest_bonds(snapshot, static_cast<std::size_t>(options.bond_neighbours))
                                     : bonds_within(snapshot, options.bond_cutoff);
}

}  // namespace packstone::analysis
