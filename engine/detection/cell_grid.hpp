// Particles sorted into equal cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/domain.hpp"
#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

/// Cells at least as wide as a cut-off, so that whatever lies within it is in the same cell or a neighbouring one.
/// Particles outside the box along an axis that is not periodic belong to its outermost cells.
class CellGrid {
 public:
  /// Sorts all positions, which lie inside the box along periodic axes. cutoff [m].
  void build(const Domain& domain, const VectorArray& position, std::size_t count, double cutoff);

  /// Calls visit(j, position of j) for every particle in the cells around a point, each cell once, in an order that
  /// depends on the positions alone.
  template <class Visit>
  void for_each_near(const Vec3& point, Visit&& visit) const {
    std::array<std::array<int, 3>, 3> around;  // cell numbers along each axis
    std::array<int, 3> count;
    for (int axis = 0; axis < 3; ++axis) count[axis] = cells_around(point[axis], axis, around[axis]);
    for (int c = 0; c < count[2]; ++c) {
      for (int b = 0; b < count[1]; ++b) {
        for (int a = 0; a < count[0]; ++a) {
          const std::size_t cell = index(around[0][a], around[1][b], around[2][c]);
          for (std::int32_t k = first_[cell]; k < first_[cell + 1]; ++k) visit(sorted_[k], sorted_position_[k]);
        }
      }
    }
  }

 private:
  std::size_t index(int a, int b, int c) const { return (static_cast<std::size_t>(c) * cells_[1] + b) * cells_[0] + a; }
  int cell_along(double coordinate, int axis) const;
  /// Writes the one to three distinct cells along an axis; returns how many.
  int cells_around(double coordinate, int axis, std::array<int, 3>& cells) const;

  Domain domain_;
  std::array<int, 3> cells_ = {1, 1, 1};
  Vec3 cells_per_metre_ = Vec3::Ones();
  std::vector<std::int32_t> first_;    ///< where each cell begins in sorted_
  std::vector<std::int32_t> sorted_;   ///< particles, cell by cell, ascending within one
  std::vector<Vec3> sorted_position_;  ///< of the same [m], so that a cell is read in one go
};

}  // namespace packstone::engine
