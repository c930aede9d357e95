// Points sorted into cells, to visit those around any place.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/domain.hpp"
#include "core/vec3.hpp"

namespace packstone::analysis {

/// A dense grid over the part of the domain that holds points, with about as many cells as points at most. Points
/// outside the domain belong to the outermost cells. Visits from several threads at once are safe; their order depends
/// on the points alone.
class PointGrid {
 public:
  /// rows: of the positions that take part; width: of a cell [m], wider where there would be too many cells.
  PointGrid(std::span<const Vec3> position, std::span<const std::uint32_t> rows, const Domain& domain, double width);

  /// Calls visit(row, d, |d|^2) for every point nearer than a distance [m] to a place; d leads from the place to the
  /// point's nearest periodic image.
  template <class Visit>
  void for_each_within(const Vec3& place, double distance, Visit&& visit) const;

  /// No point is farther from the place [m].
  double farthest(const Vec3& place) const;

 private:
  struct Span {
    std::ptrdiff_t first, last;  // cells along an axis, both included
  };
  struct Spans {
    std::array<Span, 2> span;
    int count;  // 2 across a periodic side
  };

  /// Cell along an axis before wrapping or clamping.
  double cell(double coordinate, int axis) const { return std::floor((coordinate - lower_[axis]) * per_length_[axis]); }
  std::ptrdiff_t clamped_cell(double coordinate, int axis) const {
    return static_cast<std::ptrdiff_t>(std::clamp(cell(coordinate, axis), 0.0, static_cast<double>(count_[axis] - 1)));
  }
  Spans spans(double from, double to, int axis) const;
  std::size_t index(std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) const {
    return static_cast<std::size_t>((x * count_[1] + y) * count_[2] + z);
  }

  Domain domain_;
  Vec3 lower_, upper_;     // of the cells
  Vec3 lowest_, highest_;  // of the points
  Vec3 per_length_;        // cells a metre
  std::array<std::ptrdiff_t, 3> count_{};
  std::vector<std::size_t> begin_;  // of each cell's points
  std::vector<std::uint32_t> row_;  // by cell
  std::vector<Vec3> position_;      // by cell, inside periodic sides
};

template <class Visit>
void PointGrid::for_each_within(const Vec3& place, double distance, Visit&& visit) const {
  if (row_.empty()) return;
  const Vec3 p = domain_.wrapped(place);
  const double limit = distance * distance;
  const double slack = 1e-12 * (domain_.size().maxCoeff() + distance);  // rounding of an image's coordinates
  std::array<Spans, 3> range;
  for (int k = 0; k < 3; ++k) range[k] = spans(p[k] - distance - slack, p[k] + distance + slack, k);
  // Both points lie inside the periodic sides: their images differ by one length at most, and not at all where the
  // search stays away from the sides.
  Vec3 length = Vec3::Zero(), half = Vec3::Constant(std::numeric_limits<double>::infinity());
  bool images = false;
  for (int k = 0; k < 3; ++k) {
    if (!domain_.periodic[k]) continue;
    length[k] = domain_.max[k] - domain_.min[k];
    half[k] = length[k] / 2;
    images = images || p[k] - distance < domain_.min[k] || p[k] + distance > domain_.max[k];
  }
  const auto visit_run = [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      Vec3 d = position_[slot] - p;
      if (images) {
        for (int k = 0; k < 3; ++k) d[k] -= d[k] > half[k] ? length[k] : d[k] < -half[k] ? -length[k] : 0.0;
      }
      const double squared = d.squaredNorm();
      if (squared < limit) visit(row_[slot], d, squared);
    }
  };
  for (int a = 0; a < range[0].count; ++a) {
    for (std::ptrdiff_t x = range[0].span[a].first; x <= range[0].span[a].last; ++x) {
      for (int b = 0; b < range[1].count; ++b) {
        for (std::ptrdiff_t y = range[1].span[b].first; y <= range[1].span[b].last; ++y) {
          for (int c = 0; c < range[2].count; ++c) {
            const Span& z = range[2].span[c];
            visit_run(begin_[index(x, y, z.first)], begin_[index(x, y, z.last) + 1]);
          }
        }
      }
    }
  }
}

/// Particles of similar size: radii within a factor of two, but the smallest.
struct SizeLevel {
  PointGrid grid;
  double largest;  ///< radius [m]
};

/// All particles by size, the largest first. A search for surfaces near a place goes through all levels, in each as far
/// as its largest radius demands: O(N) at any size ratio (He, Dong, Zhou, Phys. Rev. E 75 (2007) 036710).
std::vector<SizeLevel> size_levels(std::span<const Vec3> position, std::span<const double> radius,
                                   const Domain& domain);

}  // namespace packstone::analysis
