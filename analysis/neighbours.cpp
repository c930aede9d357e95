#include "analysis/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/point_grid.hpp"

namespace packstone::analysis {

namespace {

constexpr std::size_t rows_a_block = 4096;

}  // namespace

std::vector<NearPair> near_pairs(std::span<const Vec3> position, std::span<const double> radius, const Domain& domain,
                                 double gap) {
  const std::vector<SizeLevel> levels = size_levels(position, radius, domain);
  const std::size_t n = position.size();
  std::vector<std::vector<NearPair>> found((n + rows_a_block - 1) / rows_a_block);
  // From each particle to larger ones, and to later ones of its own size.
  const auto search_from = [&](std::size_t i, std::vector<NearPair>& pairs) {
    for (const SizeLevel& level : levels) {
      if (level.largest < radius[i]) break;
      const double reach = radius[i] + level.largest + gap;
      if (!(reach > 0)) continue;
      level.grid.for_each_within(position[i], reach, [&](std::uint32_t j, const Vec3&, double squared) {
        if (radius[j] < radius[i] || (radius[j] == radius[i] && j <= i)) return;
        const double limit = radius[i] + radius[j] + gap;
        if (squared >= limit * limit) return;
        pairs.push_back({static_cast<std::uint32_t>(i), j, radius[i] + radius[j] - std::sqrt(squared)});
      });
    }
  };
#pragma omp parallel for schedule(dynamic)
  for (std::size_t block = 0; block < found.size(); ++block) {
    const std::size_t last = std::min(n, (block + 1) * rows_a_block);
    for (std::size_t i = block * rows_a_block; i < last; ++i) search_from(i, found[block]);
  }
  std::size_t count = 0;
  for (const auto& pairs : found) count += pairs.size();
  std::vector<NearPair> all;
  all.reserve(count);
  for (auto& pairs : found) {
    all.insert(all.end(), pairs.begin(), pairs.end());
    pairs = {};
  }
  return all;
}

}  // namespace packstone::analysis
