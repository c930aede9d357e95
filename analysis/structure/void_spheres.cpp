#include "analysis/structure/void_spheres.hpp"

#include <cmath>
#include <limits>

namespace packstone::analysis {

namespace {

constexpr double first_share = 0.25;  // of the largest radius: how far a search goes at first
constexpr double search_growth = 2;   // of the distance, when it held no surface near enough

/// Distance to a triangle: the place's foot on its plane where that lies inside, else the nearest edge.
double to_triangle(const Vec3& place, const std::array<Vec3, 3>& corner) {
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  bool inside = !normal.isZero(0);
  double edge_squared = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = corner[k], edge = corner[(k + 1) % 3] - a, from = place - a;
    inside = inside && normal.cross(edge).dot(from) >= 0;
    const double length = edge.squaredNorm();
    const double along = length > 0 ? std::clamp(from.dot(edge) / length, 0.0, 1.0) : 0.0;
    edge_squared = std::min(edge_squared, (from - along * edge).squaredNorm());
  }
  return inside ? std::abs(normal.dot(place - corner[0])) / normal.norm() : std::sqrt(edge_squared);
}

}  // namespace

VoidSpheres::VoidSpheres(const Snapshot& snapshot)
    : levels_(size_levels(snapshot.position, snapshot.radius, snapshot.domain)),
      snapshot_(snapshot),
      spacing_(std::cbrt(snapshot.domain.size().prod() / static_cast<double>(snapshot.size()))) {
  for (const BoundaryRecord& boundary : snapshot.boundaries) {
    if (boundary.kind == "plane" && !boundary.normal.isZero(0)) planes_.push_back({boundary.point, boundary.normal});
    for (const auto& t : boundary.triangles) {
      Triangle triangle;
      for (int k = 0; k < 3; ++k) triangle.corner[k] = boundary.points[static_cast<std::size_t>(t[k])];
      triangle.low = triangle.corner[0].cwiseMin(triangle.corner[1]).cwiseMin(triangle.corner[2]);
      triangle.high = triangle.corner[0].cwiseMax(triangle.corner[1]).cwiseMax(triangle.corner[2]);
      triangles_.push_back(triangle);
    }
  }
}

double VoidSpheres::radius_at(const Vec3& place) const {
  const double particles = to_particles(place);
  return particles > 0 ? to_boundaries(place, particles) : particles;
}

double VoidSpheres::to_particles(const Vec3& place) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const SizeLevel& level : levels_) {
    const double farthest = level.grid.farthest(place);
    // All surfaces nearer than reach belong to centres nearer than reach + largest.
    const double first_reach = level.largest > 0 ? level.largest * first_share : spacing_;
    for (double reach = std::min(first_reach, nearest);; reach = std::min(search_growth * reach, nearest)) {
      const double distance = std::max(0.0, reach) + level.largest;
      level.grid.for_each_within(place, distance, [&](std::uint32_t row, const Vec3&, double squared) {
        nearest = std::min(nearest, std::sqrt(squared) - snapshot_.radius[row]);
      });
      if (nearest <= reach || distance > farthest) break;
    }
  }
  return nearest;
}

double VoidSpheres::to_boundaries(const Vec3& place, double nearest) const {
  for (const Plane& plane : planes_) nearest = std::min(nearest, plane.normal.dot(place - plane.point));
  for (const Triangle& triangle : triangles_) {
    const Vec3 outside = (triangle.low - place).cwiseMax(place - triangle.high).cwiseMax(0.0);
    if (outside.squaredNorm() < nearest * nearest) nearest = std::min(nearest, to_triangle(place, triangle.corner));
  }
  return nearest;
}

}  // namespace packstone::analysis
