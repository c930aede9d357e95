// Particles sorted into grids of cells, one grid a size class: He, Dong & Zhou, Phys. Rev. E 75 (2007) 036710.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/domain.hpp"
#include "engine/aligned_vector.hpp"
#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

/// Each particle has an extent, the radius of a sphere about its centre, and is sorted into the level of its extent,
/// whose cells are about as high as its largest spheres' extent and four times as wide. A search visits on every level
/// only the cells that its sphere can meet, so that its cost does not depend on the ratio of sizes: towards coarser
/// levels those are a handful, towards finer ones as many as particles find room in.
///
/// Positions and extents are kept in single precision, relative to the middle of the box, and extents are larger by
/// what that may cut off: a search finds every pair that meets, and hardly any other. Sixteen fit into a register that
/// way.
///
/// Within a level cells are stacked into columns along z, and columns are numbered tile by tile, so that what is close
/// in space is close in the order and a column's part of a search is one range of it.
class HierarchicalGrid {
 public:
  /// Sorts the particles. position: inside the box along periodic axes [m]; extent: [m].
  void build(const Domain& domain, const VectorArray& position, const AlignedVector<double>& extent);

  /// Numbers that build was given, in the order of the grid.
  const std::vector<std::int32_t>& order() const { return order_; }
  /// One array a coordinate [m], in the order of the grid, followed by `padding` copies of the last.
  struct Spheres {
    AlignedVector<float> x, y, z, extent;

    Vec3 position(std::size_t k) const { return {x[k], y[k], z[k]}; }
  };
  /// Relative to middle().
  const Spheres& spheres() const { return spheres_; }
  const Vec3& middle() const { return middle_; }
  double largest_extent() const { return levels_.empty() ? 0 : levels_.back().extent; }

  /// Lanes that a reader may run over the end.
  static constexpr std::size_t padding = 16;

  /// Calls visit(begin, end) for ranges of the order that together hold every particle, once, whose sphere can meet the
  /// sphere of this extent about a point, relative to middle().
  template <class Visit>
  [[gnu::always_inline]] void for_each_range(const Vec3& point, double extent, Visit&& visit) const {
    for (const Level& level : levels_) visit_level(level, point, extent, visit);
  }

 private:
  struct Level {
    double extent = 0;        ///< of its largest sphere [m]
    Vec3 low = Vec3::Zero();  ///< corner of cell (0, 0, 0) [m]
    Vec3 width = Vec3::Ones();
    Vec3 cells_per_metre = Vec3::Ones();
    std::array<int, 3> cells = {1, 1, 1};
    std::array<bool, 3> periodic = {false, false, false};
    std::int64_t first_cell = 0;  ///< into first_

    std::int64_t cell_count() const { return static_cast<std::int64_t>(cells[0]) * cells[1] * cells[2]; }
    int cell_along(double coordinate, int axis) const;
    /// Where a column's cells begin, counted from first_cell.
    std::int64_t column(int a, int b) const;
  };

  /// Cells first..last along an axis, before they are wrapped into the box; all of them once when a search is as wide
  /// as the box.
  struct Window {
    int first, last;
    bool whole;
  };

  /// Of some particles.
  struct Bounds {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    std::int64_t particles = 0;

    void add(const Vec3& position);
    void add(const Bounds& other);
  };

  void choose_levels(const AlignedVector<double>& extent, std::vector<std::uint8_t>& level_of);
  std::vector<Bounds> bounds_of_levels(const VectorArray& position, const std::vector<std::uint8_t>& level_of) const;
  void lay_out(Level& level, const Domain& domain, const Bounds& bounds) const;
  void sort(const VectorArray& position, const std::vector<std::uint8_t>& level_of, std::int64_t cells);
  static Window window(const Level& level, int axis, double coordinate, double reach);
  static int wrapped(int cell, int cells) { return cell < 0 ? cell + cells : cell >= cells ? cell - cells : cell; }

  template <class Visit>
  void visit_level(const Level& level, const Vec3& point, double extent, Visit& visit) const;
  template <class Visit>
  void visit_column(const Level& level, std::int64_t column, const Window& along_z, Visit& visit) const;

  std::vector<Level> levels_;        ///< finest first
  std::vector<std::int32_t> first_;  ///< where each cell begins in the order
  std::vector<std::int32_t> order_;
  Spheres spheres_;
  Vec3 middle_ = Vec3::Zero();
};

inline std::int64_t HierarchicalGrid::Level::column(int a, int b) const {
  constexpr int tile = 4;  // columns along either side
  const int tile_a = a / tile * tile, tile_b = b / tile * tile;
  const int columns = std::min(tile, cells[0] - tile_a), rows = std::min(tile, cells[1] - tile_b);
  const std::int64_t before = static_cast<std::int64_t>(tile_b) * cells[0] + static_cast<std::int64_t>(tile_a) * rows;
  return (before + (b - tile_b) * columns + (a - tile_a)) * cells[2];
}

inline HierarchicalGrid::Window HierarchicalGrid::window(const Level& level, int axis, double coordinate,
                                                         double reach) {
  const int last_cell = level.cells[axis] - 1;
  const double from = (coordinate - reach - level.low[axis]) * level.cells_per_metre[axis];
  const double to = (coordinate + reach - level.low[axis]) * level.cells_per_metre[axis];
  if (!level.periodic[axis]) {
    if (to < 0 || from > last_cell + 1) return {0, -1, false};
    return {static_cast<int>(std::max(from, 0.0)), static_cast<int>(std::min(to, static_cast<double>(last_cell))),
            false};
  }
  const int first = static_cast<int>(std::floor(from)), last = static_cast<int>(std::floor(to));
  if (last - first >= last_cell) return {0, last_cell, true};
  return {first, last, false};
}

template <class Visit>
[[gnu::always_inline]] inline void HierarchicalGrid::visit_level(const Level& level, const Vec3& point, double extent,
                                                                 Visit& visit) const {
  constexpr double rounding = 1 + 1e-12;  // of the windows themselves
  constexpr int few_columns = 3;          // across; of so few the sphere cuts off little
  const double reach = (extent + level.extent) * rounding;
  const Window wx = window(level, 0, point[0], reach), wy = window(level, 1, point[1], reach);
  const Window wz = window(level, 2, point[2], reach);
  if (wx.first > wx.last || wy.first > wy.last || wz.first > wz.last) return;
  const bool clip = wx.last - wx.first >= few_columns || wy.last - wy.first >= few_columns;
  const auto distance = [&](const Window& w, int cell, int axis) {  // from the point to the cell's slab
    if (w.whole) return 0.0;
    const double near = level.low[axis] + cell * level.width[axis] - point[axis];
    return std::max({near, -near - level.width[axis], 0.0}) * (2 - rounding);
  };
  for (int b = wy.first; b <= wy.last; ++b) {
    const int row = wrapped(b, level.cells[1]);
    const double dy = clip ? distance(wy, b, 1) : 0;
    for (int a = wx.first; a <= wx.last; ++a) {
      Window along_z = wz;
      if (clip) {
        const double dx = distance(wx, a, 0);
        const double squared = reach * reach - dx * dx - dy * dy;
        if (squared < 0) continue;
        along_z = window(level, 2, point[2], std::sqrt(squared));
      }
      visit_column(level, level.column(wrapped(a, level.cells[0]), row), along_z, visit);
    }
  }
}

template <class Visit>
[[gnu::always_inline]] inline void HierarchicalGrid::visit_column(const Level& level, std::int64_t column,
                                                                  const Window& along_z, Visit& visit) const {
  const std::int32_t* first = first_.data() + level.first_cell + column;
  const int cells = level.cells[2];
  // A window that leaves the box comes back at the other side.
  const int last = std::min(along_z.last, cells - 1);
  int from = std::max(along_z.first, 0), to = last;
  int other_from = 0, other_to = -1;
  if (along_z.first < 0) {
    other_from = along_z.first + cells;
    other_to = cells - 1;
  } else if (along_z.last >= cells) {
    other_to = along_z.last - cells;
  }
  for (;;) {
    if (from <= to && first[from] < first[to + 1]) visit(first[from], first[to + 1]);
    if (other_from > other_to) return;
    from = std::exchange(other_from, cells);
    to = std::exchange(other_to, -1);
  }
}

}  // namespace packstone::engine
