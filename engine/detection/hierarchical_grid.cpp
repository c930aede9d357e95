#include "engine/detection/hierarchical_grid.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// Extents of one level differ by less than this factor.
constexpr double level_ratio = 1.5;
/// Cells are wider, and hold more, where there would be more of them than this.
constexpr std::int64_t cells_per_particle = 16;
constexpr std::int64_t least_cell_limit = 1 << 16;
/// Columns are this many extents wide: a search visits few, and each fills the lanes it is read with.
constexpr double column_width = 4;
/// Cells along z over those along x and y: a range of them costs no more when they are finer.
constexpr double z_refinement = 4;
constexpr std::size_t most_levels = 256;

}  // namespace

int HierarchicalGrid::Level::cell_along(double coordinate, int axis) const {
  const double cell = (coordinate - low[axis]) * cells_per_metre[axis];
  return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells[axis] - 1)));
}

void HierarchicalGrid::choose_levels(const AlignedVector<double>& extent, std::vector<std::uint8_t>& level_of) {
  const double smallest = *std::min_element(extent.begin(), extent.end());
  const double classes_per_log = 1 / std::log(level_ratio);
  std::vector<double> largest(most_levels, 0.0);
  for (std::size_t i = 0; i < extent.size(); ++i) {
    const double size_class = smallest > 0 ? std::log(extent[i] / smallest) * classes_per_log : 0;
    level_of[i] = static_cast<std::uint8_t>(std::min(size_class, static_cast<double>(most_levels - 1)));
    largest[level_of[i]] = std::max(largest[level_of[i]], extent[i]);
  }
  std::vector<std::uint8_t> number(most_levels, 0);
  levels_.clear();
  for (std::size_t k = 0; k < most_levels; ++k) {
    if (largest[k] == 0 && !(k == 0 && smallest == 0)) continue;
    number[k] = static_cast<std::uint8_t>(levels_.size());
    levels_.emplace_back().extent = largest[k];
  }
  for (auto& level : level_of) level = number[level];
}

void HierarchicalGrid::lay_out(Level& level, const Domain& domain, const Vec3& low, const Vec3& high,
                               std::int64_t particles) const {
  level.periodic = domain.periodic;
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    const bool periodic = domain.periodic[axis];
    level.low[axis] = periodic ? domain.min[axis] : low[axis];
    size[axis] = periodic ? domain.size()[axis] : high[axis] - low[axis];
  }
  const double limit = static_cast<double>(std::max(least_cell_limit, cells_per_particle * particles));
  double width = column_width * level.extent;
  const auto cells_along = [&](int axis) {
    const double along = axis == 2 ? width / z_refinement : width;
    return std::max(1.0, std::floor(size[axis] / along));
  };
  if (width == 0) width = size.maxCoeff() + std::numeric_limits<double>::min();
  while (cells_along(0) * cells_along(1) * cells_along(2) > limit) width *= std::cbrt(2.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = cells_along(axis);
    level.cells[axis] = static_cast<int>(cells);
    level.width[axis] = size[axis] > 0 ? size[axis] / cells : width;
    level.cells_per_metre[axis] = 1 / level.width[axis];
  }
}

void HierarchicalGrid::build(const Domain& domain, const VectorArray& position, const AlignedVector<double>& extent) {
  const std::size_t n = extent.size();
  order_.resize(n);
  position_.resize(n + padding);
  extent_.resize(n + padding);
  levels_.clear();
  if (n == 0) return;

  std::vector<std::uint8_t> level_of(n);
  choose_levels(extent, level_of);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Vec3> low(levels_.size(), Vec3::Constant(infinity)), high(levels_.size(), Vec3::Constant(-infinity));
  std::vector<std::int64_t> particles(levels_.size(), 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p = position.get(i);
    low[level_of[i]] = low[level_of[i]].cwiseMin(p);
    high[level_of[i]] = high[level_of[i]].cwiseMax(p);
    ++particles[level_of[i]];
  }
  std::int64_t cells = 0;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    lay_out(levels_[k], domain, low[k], high[k], particles[k]);
    levels_[k].first_cell = cells;
    cells += levels_[k].cell_count();
  }

  std::vector<std::int32_t> cell_of(n);
  const auto count = static_cast<std::ptrdiff_t>(n);
#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const Level& level = levels_[level_of[i]];
    const std::int64_t column = level.column(level.cell_along(position.x[i], 0), level.cell_along(position.y[i], 1));
    cell_of[i] = static_cast<std::int32_t>(level.first_cell + column + level.cell_along(position.z[i], 2));
  }
  first_.assign(static_cast<std::size_t>(cells) + 1, 0);
  for (const std::int32_t cell : cell_of) ++first_[cell];
  std::int32_t before = 0;
  for (auto& entry : first_) before += std::exchange(entry, before);
  for (std::size_t i = 0; i < n; ++i) order_[first_[cell_of[i]]++] = static_cast<std::int32_t>(i);
  // Each cell's entry now points to its end, which is where the next begins.
  std::copy_backward(first_.begin(), first_.end() - 1, first_.end());
  first_.front() = 0;

#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    position_.set(k, position.get(order_[k]));
    extent_[k] = extent[order_[k]];
  }
  for (std::size_t k = n; k < n + padding; ++k) {
    position_.set(k, position_.get(n - 1));
    extent_[k] = extent_[n - 1];
  }
}

}  // namespace packstone::engine
