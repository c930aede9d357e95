// How high the packing stands at every place, to tell cells at its open surface.
#pragma once

#include <span>
#include <vector>

#include "analysis/voronoi/container.hpp"
#include "core/bed_frame.hpp"

namespace packstone::analysis {

/// Top of the spheres over columns along up.
class BedSurface {
 public:
  /// Columns of two largest diameters, and of two mean distances between particles at least, across the container. None
  /// where the container is periodic along up: such a packing has no surface.
  BedSurface(const BedFrame& frame, const CellContainer& container, std::span<const Vec3> centre,
             std::span<const double> radius);

  /// Whether a point lies above all spheres whose centres its column holds, by more than their mean radius. In a column
  /// without spheres, whether it lies that far above the lower end of the container.
  bool below(const Vec3& point) const;

  /// Whether no point of a ball can lie that far above; quick, and false too often near the surface.
  bool above_ball(const Vec3& middle, double radius) const {
    return top_.empty() || sign_ * middle[axis_] + radius <= lowest_top_ + slack_;
  }

 private:
  std::size_t column_of(const Vec3& point) const;

  int axis_;
  double sign_;
  double slack_ = 0;  // [m]
  Domain box_;
  int across_[2];
  std::size_t count_[2] = {};
  double lowest_top_ = 0;    // [m]
  std::vector<double> top_;  // of each column, along up [m]; none without a surface
};

}  // namespace packstone::analysis
