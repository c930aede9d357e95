#include "analysis/voronoi/bed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace packstone::analysis {

namespace {

constexpr double column_in_radii = 4;      // of the largest sphere
constexpr double column_in_distances = 2;  // between particles, mean

}  // namespace

BedSurface::BedSurface(const BedFrame& frame, const CellContainer& container, std::span<const Vec3> centre,
                       std::span<const double> radius)
    : axis_(frame.axis), sign_(frame.sign), box_(container.box), across_{(frame.axis + 1) % 3, (frame.axis + 2) % 3} {
  if (box_.periodic[axis_] || centre.empty()) return;
  const double n = static_cast<double>(centre.size());
  const Vec3 size = box_.size();
  const double width = std::max(column_in_radii * *std::max_element(radius.begin(), radius.end()),
                                column_in_distances * std::cbrt(size.prod() / n));
  for (int side = 0; side < 2; ++side) {
    // No more columns than particles, however flat the container.
    const double most = std::max(1.0, std::sqrt(n));
    count_[side] = static_cast<std::size_t>(std::clamp(std::floor(size[across_[side]] / width), 1.0, most));
  }
  slack_ = std::accumulate(radius.begin(), radius.end(), 0.0) / n;
  top_.assign(count_[0] * count_[1], sign_ > 0 ? box_.min[axis_] : -box_.max[axis_]);
  for (std::size_t i = 0; i < centre.size(); ++i) {
    double& top = top_[column_of(centre[i])];
    top = std::max(top, sign_ * centre[i][axis_] + radius[i]);
  }
  lowest_top_ = *std::min_element(top_.begin(), top_.end());
}

bool BedSurface::below(const Vec3& point) const {
  return !top_.empty() && sign_ * point[axis_] > top_[column_of(point)] + slack_;
}

std::size_t BedSurface::column_of(const Vec3& point) const {
  const Vec3 offset = box_.wrapped(point) - box_.min;
  std::size_t index[2];
  for (int side = 0; side < 2; ++side) {
    const int k = across_[side];
    const double column = std::floor(offset[k] / box_.size()[k] * static_cast<double>(count_[side]));
    index[side] = static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(count_[side] - 1)));
  }
  return index[0] + count_[0] * index[1];
}

}  // namespace packstone::analysis
