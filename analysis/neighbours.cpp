#include "analysis/neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

namespace packstone::analysis {

namespace {

using Cell = std::array<std::int64_t, 3>;

constexpr int most_levels = 24;           // sizes below 2^-23 of the largest share the finest level
constexpr double farthest_cell = 0x1p40;  // keeps the cell of a lost particle within an integer
constexpr std::uint64_t hash_factor[3] = {0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu, 0x165667B19E3779F9u};

/// One level of the grid: particles of similar size in cells at least as wide as the largest of them.
class Level {
 public:
  Level(std::vector<std::uint32_t> rows, std::span<const Vec3> position, double reach, const Domain& domain)
      : reach_(reach), domain_(domain) {
    for (int k = 0; k < 3; ++k) {
      const double length = domain.max[k] - domain.min[k];
      count_[k] = domain.periodic[k] ? std::max<std::int64_t>(1, cell_index(length / (2 * reach))) : 0;
      width_[k] = domain.periodic[k] ? length / static_cast<double>(count_[k]) : 2 * reach;
    }
    sort_into_buckets(std::move(rows), position);
  }

  /// Calls visit(row) for every particle in the cells within a distance of a point.
  template <class Visit>
  void for_each_near(const Vec3& point, double distance, Visit&& visit) const {
    Cell low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] = cell_index((point[k] - distance - domain_.min[k]) / width_[k]);
      high[k] = cell_index((point[k] + distance - domain_.min[k]) / width_[k]);
      if (domain_.periodic[k] && high[k] - low[k] + 1 >= count_[k]) {
        low[k] = 0;
        high[k] = count_[k] - 1;
      }
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
          visit_cell({wrapped(x, 0), wrapped(y, 1), wrapped(z, 2)}, visit);
      }
    }
  }

  double reach() const { return reach_; }

 private:
  static std::int64_t cell_index(double offset) {
    return static_cast<std::int64_t>(std::clamp(std::floor(offset), -farthest_cell, farthest_cell));
  }

  std::int64_t wrapped(std::int64_t index, int axis) const {
    if (!domain_.periodic[axis]) return index;
    const std::int64_t rest = index % count_[axis];
    return rest < 0 ? rest + count_[axis] : rest;
  }

  std::size_t bucket_of(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) hash = (hash ^ static_cast<std::uint64_t>(cell[k])) * hash_factor[k];
    return static_cast<std::size_t>((hash ^ (hash >> 32)) & (begin_.size() - 2));
  }

  Cell cell_of(const Vec3& point) const {
    Cell cell;
    for (int k = 0; k < 3; ++k) cell[k] = wrapped(cell_index((point[k] - domain_.min[k]) / width_[k]), k);
    return cell;
  }

  void sort_into_buckets(std::vector<std::uint32_t> rows, std::span<const Vec3> position) {
    const std::size_t buckets = std::bit_ceil(std::max<std::size_t>(rows.size(), 1));
    begin_.assign(buckets + 1, 0);
    std::vector<std::size_t> bucket(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      bucket[i] = bucket_of(cell_of(position[rows[i]]));
      ++begin_[bucket[i] + 1];
    }
    for (std::size_t b = 0; b < buckets; ++b) begin_[b + 1] += begin_[b];
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    rows_.resize(rows.size());
    cells_.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t slot = next[bucket[i]]++;
      rows_[slot] = rows[i];
      cells_[slot] = cell_of(position[rows[i]]);
    }
  }

  template <class Visit>
  void visit_cell(const Cell& cell, Visit&& visit) const {
    const std::size_t bucket = bucket_of(cell);
    for (std::size_t slot = begin_[bucket]; slot < begin_[bucket + 1]; ++slot) {
      if (cells_[slot] == cell) visit(rows_[slot]);
    }
  }

  double reach_;  // half the largest diameter
  const Domain& domain_;
  Cell count_{};  // cells along periodic axes
  std::array<double, 3> width_{};
  std::vector<std::size_t> begin_;  // of each bucket in rows_
  std::vector<std::uint32_t> rows_;
  std::vector<Cell> cells_;
};

struct Hierarchy {
  std::vector<Level> levels;          // coarse to fine
  std::vector<std::size_t> level_of;  // (N)
};

Hierarchy sorted_by_size(std::span<const Vec3> position, std::span<const double> reach, const Domain& domain) {
  Hierarchy hierarchy;
  const double largest = *std::max_element(reach.begin(), reach.end());
  std::vector<std::vector<std::uint32_t>> rows(most_levels);
  std::vector<double> level_reach(most_levels, 0.0);
  hierarchy.level_of.resize(reach.size());
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const double halvings = reach[i] > 0 ? std::floor(std::log2(largest / reach[i])) : most_levels;
    const auto level = static_cast<std::size_t>(std::clamp(halvings, 0.0, most_levels - 1.0));
    rows[level].push_back(static_cast<std::uint32_t>(i));
    level_reach[level] = std::max(level_reach[level], reach[i]);
    hierarchy.level_of[i] = level;
  }
  std::vector<std::size_t> position_of_level(most_levels, 0);
  for (int level = 0; level < most_levels; ++level) {
    if (rows[level].empty()) continue;
    const double cell_reach = std::max(level_reach[level], largest * std::exp2(-most_levels));
    position_of_level[level] = hierarchy.levels.size();
    hierarchy.levels.emplace_back(std::move(rows[level]), position, cell_reach, domain);
  }
  for (auto& level : hierarchy.level_of) level = position_of_level[level];
  return hierarchy;
}

}  // namespace

std::vector<NearPair> near_pairs(std::span<const Vec3> position, std::span<const double> radius, const Domain& domain,
                                 double gap) {
  std::vector<NearPair> pairs;
  std::vector<double> reach(radius.begin(), radius.end());
  for (double& r : reach) r += gap / 2;
  if (reach.empty() || !(*std::max_element(reach.begin(), reach.end()) > 0)) return pairs;

  std::vector<Vec3> inside;
  inside.reserve(position.size());
  for (const auto& p : position) inside.push_back(domain.wrapped(p));

  const Hierarchy hierarchy = sorted_by_size(inside, reach, domain);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    for (std::size_t level = 0; level <= hierarchy.level_of[i]; ++level) {
      const Level& partners = hierarchy.levels[level];
      const bool same = level == hierarchy.level_of[i];
      partners.for_each_near(inside[i], reach[i] + partners.reach(), [&](std::uint32_t j) {
        if (same && j <= i) return;
        const double limit = reach[i] + reach[j];
        const double squared = domain.separation(inside[i], inside[j]).squaredNorm();
        if (squared >= limit * limit) return;
        pairs.push_back({static_cast<std::uint32_t>(i), j, radius[i] + radius[j] - std::sqrt(squared)});
      });
    }
  }
  return pairs;
}

}  // namespace packstone::analysis
