#include "analysis/voronoi/cell_walls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace packstone::analysis {

namespace {

constexpr double facet_distance = 1e-3;  // of a tube's facets from the tube, in mean radii
constexpr double fewest_facets = 96;
constexpr double most_facets = 4096;

/// Keeps the part where normal . x <= offset.
bool cut_by_plane(voro::voronoicell& cell, const Vec3& at, const Vec3& normal, double offset) {
  return cell.plane(normal.x(), normal.y(), normal.z(), 2 * (offset - normal.dot(at)));
}

}  // namespace

Vec3 CellWalls::Prism::normal(int facet) const {
  const double angle = 2 * std::numbers::pi * facet / facets;
  return std::cos(angle) * first + std::sin(angle) * second;
}

CellWalls::CellWalls(const CellContainer& container, const CellFrame& frame, double mean_radius) {
  for (const HalfSpace& plane : container.planes) {
    planes_.push_back({plane.normal, (plane.offset - plane.normal.dot(frame.origin)) / frame.unit});
  }
  for (const Tube& tube : container.tubes) {
    Prism prism;
    prism.centre = frame.scaled(tube.centre);
    prism.first = tube.axis.unitOrthogonal();
    prism.second = tube.axis.cross(prism.first);
    // The edges of n facets of equal cross-section lie R (pi / n)^2 / 3 outside, their middles half of that inside.
    const double facets = std::numbers::pi * std::sqrt(tube.radius / (3 * facet_distance * mean_radius));
    prism.facets = static_cast<int>(std::clamp(std::ceil(facets), fewest_facets, most_facets));
    const double half_facet = std::numbers::pi / prism.facets;
    prism.apothem = tube.radius / frame.unit * std::sqrt(half_facet / std::tan(half_facet));
    prisms_.push_back(prism);
  }
}

bool CellWalls::cut(voro::voronoicell& cell, const Vec3& at) const {
  return std::all_of(planes_.begin(), planes_.end(),
                     [&](const HalfSpace& plane) { return cut_by_plane(cell, at, -plane.normal, -plane.offset); }) &&
         std::all_of(prisms_.begin(), prisms_.end(), [&](const Prism& prism) { return cut_by_prism(cell, at, prism); });
}

double CellWalls::volume_within(const Vec3& size) const {
  voro::voronoicell cell;
  const Vec3 middle = size / 2;
  cell.init(-middle.x(), middle.x(), -middle.y(), middle.y(), -middle.z(), middle.z());
  return cut(cell, middle) ? cell.volume() : 0;
}

/// By the facets from the nearest on, to both sides, until the cell reaches no further one.
bool CellWalls::cut_by_prism(voro::voronoicell& cell, const Vec3& at, const Prism& prism) {
  const Vec3 arm = at - prism.centre;
  const double x = arm.dot(prism.first), y = arm.dot(prism.second), distance = std::hypot(x, y);
  const double step = 2 * std::numbers::pi / prism.facets;
  const int nearest = static_cast<int>(std::lround(std::atan2(y, x) / step));
  const auto cut_by = [&](int facet) {
    const Vec3 normal = prism.normal(facet);
    return cut_by_plane(cell, at, normal, prism.apothem + normal.dot(prism.centre));
  };
  for (int k = 0; k <= prism.facets / 2; ++k) {
    // The nearest facet's normal may be half a step off the particle's direction.
    const double turn = std::max(0.0, k - 0.5) * step;
    if (distance * std::cos(turn) + reach(cell) <= prism.apothem) return true;
    if (!cut_by(nearest + k) || (k > 0 && !cut_by(nearest - k))) return false;
  }
  return true;
}

}  // namespace packstone::analysis
