#include "analysis/point_grid.hpp"

#include <limits>

namespace packstone::analysis {

namespace {

constexpr double cells_per_point = 2;
constexpr double coarsening = 1.26;  // of the width, halves the number of cells
constexpr int most_levels = 24;      // sizes below 2^-23 of the largest share the finest level

}  // namespace

PointGrid::PointGrid(std::span<const Vec3> position, std::span<const std::uint32_t> rows, const Domain& domain,
                     double width)
    : domain_(domain), lower_(domain.min), upper_(domain.max) {
  const double infinity = std::numeric_limits<double>::infinity();
  lowest_.setConstant(infinity);
  highest_.setConstant(-infinity);
  std::vector<Vec3> inside;
  inside.reserve(rows.size());
  for (const std::uint32_t row : rows) {
    inside.push_back(domain.wrapped(position[row]));
    lowest_ = lowest_.cwiseMin(inside.back());
    highest_ = highest_.cwiseMax(inside.back());
  }
  for (int k = 0; k < 3; ++k) {
    if (domain.periodic[k] || rows.empty()) continue;
    lower_[k] = std::clamp(lowest_[k], domain.min[k], domain.max[k]);
    upper_[k] = std::clamp(highest_[k], lower_[k], domain.max[k]);
  }
  const Vec3 size = upper_ - lower_;
  const double most = cells_per_point * static_cast<double>(rows.size()) + 1;
  double cell_width = std::max(width, size.maxCoeff() / most);
  const auto cells = [&](int k) { return cell_width > 0 ? std::max(1.0, std::floor(size[k] / cell_width)) : 1.0; };
  while (cells(0) * cells(1) * cells(2) > most) cell_width *= coarsening;
  for (int k = 0; k < 3; ++k) {
    count_[k] = static_cast<std::ptrdiff_t>(cells(k));
    per_length_[k] = size[k] > 0 ? cells(k) / size[k] : 0;
  }

  begin_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
  std::vector<std::size_t> cell_of(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec3& p = inside[i];
    cell_of[i] = index(clamped_cell(p[0], 0), clamped_cell(p[1], 1), clamped_cell(p[2], 2));
    ++begin_[cell_of[i] + 1];
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  row_.resize(rows.size());
  position_.resize(rows.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t slot = next[cell_of[i]]++;
    row_[slot] = rows[i];
    position_[slot] = inside[i];
  }
}

PointGrid::Spans PointGrid::spans(double from, double to, int axis) const {
  const std::ptrdiff_t count = count_[axis];
  if (!domain_.periodic[axis]) return {{Span{clamped_cell(from, axis), clamped_cell(to, axis)}}, 1};
  const double low = cell(from, axis), high = cell(to, axis);
  if (high - low + 1 >= static_cast<double>(count)) return {{Span{0, count - 1}}, 1};
  const auto first = static_cast<std::ptrdiff_t>(low), last = static_cast<std::ptrdiff_t>(high);
  if (first < 0) return {{Span{first + count, count - 1}, Span{0, last}}, 2};
  if (last >= count) return {{Span{first, count - 1}, Span{0, last - count}}, 2};
  return {{Span{first, last}}, 1};
}

double PointGrid::farthest(const Vec3& place) const {
  if (row_.empty()) return 0;
  const Vec3 p = domain_.wrapped(place);
  Vec3 most = (p - lowest_).cwiseAbs().cwiseMax((highest_ - p).cwiseAbs());
  for (int k = 0; k < 3; ++k) {
    if (domain_.periodic[k]) most[k] = (domain_.max[k] - domain_.min[k]) / 2;
  }
  return most.norm();
}

std::vector<SizeLevel> size_levels(std::span<const Vec3> position, std::span<const double> radius,
                                   const Domain& domain) {
  std::vector<SizeLevel> levels;
  if (radius.empty()) return levels;
  const double largest = *std::max_element(radius.begin(), radius.end());
  std::vector<std::vector<std::uint32_t>> rows(most_levels);
  std::vector<double> level_largest(most_levels, 0.0);
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double halvings = radius[i] > 0 ? std::floor(std::log2(largest / radius[i])) : most_levels;
    const auto level = static_cast<std::size_t>(std::clamp(halvings, 0.0, most_levels - 1.0));
    rows[level].push_back(static_cast<std::uint32_t>(i));
    level_largest[level] = std::max(level_largest[level], radius[i]);
  }
  for (int level = 0; level < most_levels; ++level) {
    if (rows[level].empty()) continue;
    levels.push_back({PointGrid(position, rows[level], domain, level_largest[level]), level_largest[level]});
  }
  return levels;
}

}  // namespace packstone::analysis
