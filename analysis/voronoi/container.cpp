#include "analysis/voronoi/container.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace packstone::analysis {

namespace {

constexpr double most_outside = 0.01;      // share of the centres, of a boundary that holds the packing
constexpr double rounding = 1e-9;          // of directions, and of a boundary's size
constexpr std::size_t most_planes = 64;    // of one boundary; a mesh of more is no container of flat walls
constexpr double margin_in_radii = 4;      // of the largest sphere
constexpr double margin_in_extents = 0.1;  // of the packing

/// What one boundary encloses; nothing when it is of no use.
struct Enclosure {
  std::vector<HalfSpace> planes = {};
  std::vector<Tube> tubes = {};

  bool empty() const { return planes.empty() && tubes.empty(); }
};

bool inside(const std::vector<HalfSpace>& planes, const std::vector<Tube>& tubes, const Vec3& point) {
  for (const HalfSpace& plane : planes) {
    if (!(plane.normal.dot(point) >= plane.offset)) return false;
  }
  for (const Tube& tube : tubes) {
    if (!(tube.axis.cross(point - tube.centre).squaredNorm() <= tube.radius * tube.radius)) return false;
  }
  return true;
}

Vec3 mean_point(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  return mean;
}

double extent(const std::vector<Vec3>& points) {
  const Vec3 mean = mean_point(points);
  double farthest = 0;
  for (const Vec3& p : points) farthest = std::max(farthest, (p - mean).norm());
  return farthest;
}

bool same_plane(const HalfSpace& a, const HalfSpace& b, double slack) {
  return (a.normal - b.normal).norm() < rounding && std::abs(a.offset - b.offset) < slack;
}

/// The planes of a one-sided surface; none unless it is convex towards the particles.
Enclosure flat_enclosure(const BoundaryRecord& record) {
  Enclosure enclosure;
  const double slack = rounding * extent(record.points);
  for (const auto& [a, b, c] : record.triangles) {
    const Vec3& corner = record.points[static_cast<std::size_t>(a)];
    const Vec3 normal = (record.points[static_cast<std::size_t>(b)] - corner)
                            .cross(record.points[static_cast<std::size_t>(c)] - corner);
    if (!(normal.norm() > slack * slack)) continue;
    HalfSpace plane{normal.normalized()};
    plane.offset = plane.normal.dot(corner);
    auto& planes = enclosure.planes;
    if (std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& h) { return same_plane(h, plane, slack); })) {
      continue;
    }
    const bool convex = std::all_of(record.points.begin(), record.points.end(),
                                    [&](const Vec3& p) { return plane.normal.dot(p) >= plane.offset - slack; });
    if (!convex || planes.size() == most_planes) return {};
    planes.push_back(plane);
  }
  return enclosure;
}

/// Facets of a cylinder face its axis when particles are inside, and away from it when they are outside.
bool faces_axis(const BoundaryRecord& record, const Tube& tube) {
  double inwards = 0;
  for (const auto& [a, b, c] : record.triangles) {
    const Vec3& p = record.points[static_cast<std::size_t>(a)];
    const Vec3& q = record.points[static_cast<std::size_t>(b)];
    const Vec3& r = record.points[static_cast<std::size_t>(c)];
    inwards += (q - p).cross(r - p).dot(tube.centre - (p + q + r) / 3);
  }
  return inwards > 0;
}

/// A cylinder from what the snapshot keeps of it: its axis, its cross-section, and facets in rings around the axis. A
/// closed end has a ring that shrank to a point of the axis.
Enclosure round_enclosure(const BoundaryRecord& record) {
  if (!(record.cross_section > 0) || record.axis.isZero(0)) return {};
  const Tube tube{mean_point(record.points), record.axis.normalized(),
                  std::sqrt(record.cross_section / std::numbers::pi)};
  if (!faces_axis(record, tube)) return {};
  Enclosure enclosure{.tubes = {tube}};
  const auto along = [&](const Vec3& p) { return tube.axis.dot(p); };
  const auto [lowest, highest] = std::minmax_element(record.points.begin(), record.points.end(),
                                                     [&](const Vec3& a, const Vec3& b) { return along(a) < along(b); });
  const double slack = rounding * extent(record.points), low = along(*lowest), high = along(*highest);
  bool closed_below = false, closed_above = false;
  for (const Vec3& p : record.points) {
    if (!(tube.axis.cross(p - tube.centre).norm() < slack)) continue;
    closed_below = closed_below || along(p) < low + slack;
    closed_above = closed_above || along(p) > high - slack;
  }
  if (closed_below) enclosure.planes.push_back({tube.axis, low});
  if (closed_above) enclosure.planes.push_back({-tube.axis, -high});
  return enclosure;
}

Enclosure enclosure_of(const BoundaryRecord& record) {
  if (record.kind == "plane" && !record.normal.isZero(0)) {
    const Vec3 normal = record.normal.normalized();
    return {.planes = {{normal, normal.dot(record.point)}}};
  }
  if (!record.one_sided || record.triangles.empty()) return {};
  return record.kind == "cylinder" ? round_enclosure(record) : flat_enclosure(record);
}

bool holds_packing(const Enclosure& enclosure, std::span<const Vec3> centre) {
  if (enclosure.empty()) return false;
  const auto outside = std::count_if(centre.begin(), centre.end(),
                                     [&](const Vec3& p) { return !inside(enclosure.planes, enclosure.tubes, p); });
  return static_cast<double>(outside) <= most_outside * static_cast<double>(centre.size());
}

/// A boundary that is not there at the time has no geometry.
bool is_there(const BoundaryRecord& record) { return !record.normal.isZero(0) || !record.triangles.empty(); }

/// Moves the side of the box that a plane square to an axis replaces; false for any other plane.
bool moved_side(Domain& box, const HalfSpace& plane) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(plane.normal[k]) < 1 - rounding * rounding) continue;
    if (plane.normal[k] > 0) box.min[k] = std::max(box.min[k], plane.offset);
    if (plane.normal[k] < 0) box.max[k] = std::min(box.max[k], -plane.offset);
    return true;
  }
  return false;
}

void add(CellContainer& container, const Enclosure& enclosure) {
  Domain& box = container.box;
  for (const HalfSpace& plane : enclosure.planes) {
    for (int k = 0; k < 3; ++k) box.periodic[k] = box.periodic[k] && std::abs(plane.normal[k]) < rounding;
    if (!moved_side(box, plane)) container.planes.push_back(plane);
  }
  for (const Tube& tube : enclosure.tubes) {
    for (int k = 0; k < 3; ++k) box.periodic[k] = box.periodic[k] && std::abs(tube.axis[k]) > 1 - rounding;
    container.tubes.push_back(tube);
  }
}

/// Brings open sides that are far off nearer.
void crop(Domain& box, std::span<const Vec3> centre, double largest_radius) {
  Vec3 low = centre.front(), high = centre.front();
  for (const Vec3& p : centre) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double margin = margin_in_radii * largest_radius + margin_in_extents * (high - low).maxCoeff();
  if (!(margin > 0)) return;
  for (int k = 0; k < 3; ++k) {
    if (box.periodic[k]) continue;
    box.min[k] = std::max(box.min[k], low[k] - margin);
    box.max[k] = std::min(box.max[k], high[k] + margin);
  }
}

}  // namespace

bool CellContainer::holds(const Vec3& point) const {
  for (int k = 0; k < 3; ++k) {
    if (!box.periodic[k] && !(point[k] >= box.min[k] && point[k] <= box.max[k])) return false;
  }
  return inside(planes, tubes, point);
}

CellContainer cell_container(const Snapshot& snapshot, std::span<const Vec3> centre) {
  CellContainer container{.box = snapshot.domain};
  for (const BoundaryRecord& record : snapshot.boundaries) {
    const Enclosure enclosure = enclosure_of(record);
    if (holds_packing(enclosure, centre)) {
      add(container, enclosure);
    } else if (is_there(record)) {
      container.left_out.push_back(record.name + " (" + record.kind + ")");
    }
  }
  crop(container.box, centre, *std::max_element(snapshot.radius.begin(), snapshot.radius.end()));
  return container;
}

}  // namespace packstone::analysis
