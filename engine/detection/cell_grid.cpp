#include "engine/detection/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::engine {

namespace {

/// More cells than this a particle cost more to visit than they save.
constexpr double cells_per_particle = 2;

}  // namespace

int CellGrid::cell_along(double coordinate, int axis) const {
  const double cell = (coordinate - domain_.min[axis]) * cells_per_metre_[axis];
  return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells_[axis] - 1)));
}

int CellGrid::cells_around(double coordinate, int axis, std::array<int, 3>& cells) const {
  const int here = cell_along(coordinate, axis), last = cells_[axis] - 1;
  int count = 0;
  for (int offset = -1; offset <= 1; ++offset) {
    int cell = here + offset;
    if (cell < 0 || cell > last) {
      if (!domain_.periodic[axis]) continue;
      cell = cell < 0 ? last : 0;
    }
    if (std::find(cells.begin(), cells.begin() + count, cell) == cells.begin() + count) cells[count++] = cell;
  }
  return count;
}

void CellGrid::build(const Domain& domain, const VectorArray& position, std::size_t count, double cutoff) {
  domain_ = domain;
  const Vec3 size = domain.size();
  const double width = std::max(
      cutoff, std::cbrt(size.prod() / (cells_per_particle * static_cast<double>(std::max<std::size_t>(count, 1)))));
  for (int axis = 0; axis < 3; ++axis) {
    cells_[axis] = std::max(1, static_cast<int>(size[axis] / width));
    cells_per_metre_[axis] = cells_[axis] / size[axis];
  }
  first_.assign(index(0, 0, cells_[2]) + 1, 0);
  std::vector<std::int32_t> cell_of(count);
  for (std::size_t i = 0; i < count; ++i) {
    cell_of[i] = static_cast<std::int32_t>(
        index(cell_along(position.x[i], 0), cell_along(position.y[i], 1), cell_along(position.z[i], 2)));
    ++first_[cell_of[i] + 1];
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  sorted_.resize(count);
  sorted_position_.resize(count);
  std::vector<std::int32_t> fill(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t k = fill[cell_of[i]]++;
    sorted_[k] = static_cast<std::int32_t>(i);
    sorted_position_[k] = position.get(i);
  }
}

}  // namespace packstone::engine
