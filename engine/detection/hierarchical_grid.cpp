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
/// Of a particle's largest coordinate: its share of what rounding to single precision, of the periodic side as well,
/// comes to along the diagonal, with some to spare.
constexpr double rounding_of_places = 0x1p-21;
/// Of a distance worked out in single precision, with some to spare.
constexpr double rounding_of_distances = 1e-6;

}  // namespace

int HierarchicalGrid::Level::cell_along(double coordinate, int axis) const {
  const double cell = (coordinate - low[axis]) * cells_per_metre[axis];
  return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells[axis] - 1)));
}

void HierarchicalGrid::Bounds::add(const Vec3& position) {
  low = low.cwiseMin(position);
  high = high.cwiseMax(position);
  ++particles;
}

void HierarchicalGrid::Bounds::add(const Bounds& other) {
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
  particles += other.particles;
}

void HierarchicalGrid::choose_levels(const AlignedVector<double>& extent, std::vector<std::uint8_t>& level_of) {
  const double smallest = *std::min_element(extent.begin(), extent.end());
  const double classes_per_log = 1 / std::log(level_ratio);
  std::vector<double> largest(most_levels, 0.0);
  const auto count = static_cast<std::ptrdiff_t>(extent.size());
#pragma omp parallel num_threads(useful_threads(extent.size()))
  {
    std::vector<double> largest_here(most_levels, 0.0);
#pragma omp for schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const double ratio = smallest > 0 ? extent[i] / smallest : 1;
      const double size_class = ratio < level_ratio ? 0 : std::log(ratio) * classes_per_log;
      level_of[i] = static_cast<std::uint8_t>(std::min(size_class, static_cast<double>(most_levels - 1)));
      largest_here[level_of[i]] = std::max(largest_here[level_of[i]], extent[i]);
    }
#pragma omp critical
    std::transform(largest.begin(), largest.end(), largest_here.begin(), largest.begin(),
                   [](double a, double b) { return std::max(a, b); });
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

std::vector<HierarchicalGrid::Bounds> HierarchicalGrid::bounds_of_levels(
    const VectorArray& position, const std::vector<std::uint8_t>& level_of) const {
  std::vector<Bounds> bounds(levels_.size());
  const auto count = static_cast<std::ptrdiff_t>(level_of.size());
#pragma omp parallel num_threads(useful_threads(level_of.size()))
  {
    std::vector<Bounds> bounds_here(levels_.size());
#pragma omp for schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) bounds_here[level_of[i]].add(position.get(i));
#pragma omp critical
    for (std::size_t k = 0; k < bounds.size(); ++k) bounds[k].add(bounds_here[k]);
  }
  return bounds;
}

void HierarchicalGrid::lay_out(Level& level, const Domain& domain, const Bounds& bounds) const {
  level.periodic = domain.periodic;
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    const bool periodic = domain.periodic[axis];
    level.low[axis] = (periodic ? domain.min[axis] : bounds.low[axis]) - middle_[axis];
    size[axis] = periodic ? domain.size()[axis] : bounds.high[axis] - bounds.low[axis];
  }
  const double limit = static_cast<double>(std::max(least_cell_limit, cells_per_particle * bounds.particles));
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

void HierarchicalGrid::sort(const VectorArray& position, const std::vector<std::uint8_t>& level_of,
                            std::int64_t cells) {
  std::vector<std::int32_t> cell_of(level_of.size());
  const auto count = static_cast<std::ptrdiff_t>(level_of.size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(level_of.size()))
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const Level& level = levels_[level_of[i]];
    const Vec3 p = position.get(i) - middle_;
    const std::int64_t column = level.column(level.cell_along(p[0], 0), level.cell_along(p[1], 1));
    cell_of[i] = static_cast<std::int32_t>(level.first_cell + column + level.cell_along(p[2], 2));
  }
  first_.assign(static_cast<std::size_t>(cells) + 1, 0);
  for (const std::int32_t cell : cell_of) ++first_[cell];
  std::int32_t before = 0;
  for (auto& entry : first_) before += std::exchange(entry, before);
  order_.resize(level_of.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) order_[first_[cell_of[i]]++] = static_cast<std::int32_t>(i);
  // Each cell's entry now points to its end, which is where the next begins.
  std::copy_backward(first_.begin(), first_.end() - 1, first_.end());
  first_.front() = 0;
}

void HierarchicalGrid::build(const Domain& domain, const VectorArray& position, const AlignedVector<double>& extent) {
  const std::size_t n = extent.size();
  levels_.clear();
  order_.clear();
  if (n == 0) return;

  middle_ = 0.5 * (domain.min + domain.max);
  const auto count = static_cast<std::ptrdiff_t>(n);
  AlignedVector<double> allowed(n);
#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const double farthest = (position.get(i) - middle_).cwiseAbs().maxCoeff();
    allowed[i] = static_cast<float>((extent[i] + rounding_of_places * farthest) * (1 + rounding_of_distances));
  }
  std::vector<std::uint8_t> level_of(n);
  choose_levels(allowed, level_of);
  const std::vector<Bounds> bounds = bounds_of_levels(position, level_of);
  std::int64_t cells = 0;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    lay_out(levels_[k], domain, bounds[k]);
    levels_[k].first_cell = cells;
    cells += levels_[k].cell_count();
  }
  sort(position, level_of, cells);

  for (AlignedVector<float>* array : {&spheres_.x, &spheres_.y, &spheres_.z, &spheres_.extent}) {
    array->resize(n + padding);
  }
  const auto put = [&](std::size_t k, std::int32_t i) {
    const Vec3 p = position.get(i) - middle_;
    spheres_.x[k] = static_cast<float>(p[0]);
    spheres_.y[k] = static_cast<float>(p[1]);
    spheres_.z[k] = static_cast<float>(p[2]);
    spheres_.extent[k] = static_cast<float>(allowed[i]);
  };
#pragma omp parallel for schedule(static) num_threads(useful_threads(n))
  for (std::ptrdiff_t k = 0; k < count; ++k) put(k, order_[k]);
  for (std::size_t k = n; k < n + padding; ++k) put(k, order_[n - 1]);
}

}  // namespace packstone::engine
