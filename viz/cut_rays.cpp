#include "viz/cut_rays.hpp"

#include <limits>

namespace packstone::viz {

CutRays::CutRays(const CutAway& cut, const Vec3& origin, double scale, const Camera& camera)
    : cut_(cut), camera_(camera) {
  for (HalfSpace& half : cut_) half.place = (half.place - origin[half.axis]) * scale;
}

CutSpan CutRays::span(int row, int column) const {
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  const Point middle{column + 0.5, row + 0.5};
  const Vec3 start = camera_.point_at(middle, 0), way = camera_.point_at(middle, 1) - start;
  CutSpan span{-everywhere, everywhere, Vec3::Zero()};
  for (const HalfSpace& half : cut_) {
    const double speed = way[half.axis];
    if (speed == 0) {
      if (!half.holds(start)) return {0, 0, Vec3::Zero()};
      continue;
    }
    const double crossed = (half.place - start[half.axis]) / speed;
    if ((speed > 0) == half.above) {
      span.from = std::max(span.from, crossed);
    } else if (crossed < span.to) {
      const auto& axes = camera_.axes();
      const double side = half.above ? 1 : -1;
      span.to = crossed;
      span.normal = side * Vec3(axes[0][half.axis], -axes[1][half.axis], -axes[2][half.axis]);
    }
  }
  return span;
}

}  // namespace packstone::viz
