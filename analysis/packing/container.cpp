#include "analysis/packing/container.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace packstone::analysis {

namespace {

constexpr double upright = 1 - 1e-9;  // least component of an axis or a normal, as for bed_frame
constexpr double rounding = 1e-6;     // share by which a recorded shape may differ from the recorded cross-section

/// The boundary of the smallest upright cross-section, as bed_frame chooses it.
std::optional<std::size_t> narrowest(const Snapshot& snapshot, int axis) {
  const Vec3 size = snapshot.domain.size();
  double area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  std::optional<std::size_t> found;
  for (std::size_t b = 0; b < snapshot.boundaries.size(); ++b) {
    const BoundaryRecord& boundary = snapshot.boundaries[b];
    const bool along_up = std::abs(boundary.axis[axis]) >= upright;
    if (!along_up || !(boundary.cross_section > 0) || boundary.cross_section >= area) continue;
    area = boundary.cross_section;
    found = b;
  }
  return found;
}

void take_cylinder(Container& container, const BoundaryRecord& boundary, const Domain& domain) {
  container.round = true;
  container.radius = std::sqrt(boundary.cross_section / std::numbers::pi);
  if (!boundary.points.empty()) {
    container.centre = Vec3::Zero();
    for (const Vec3& p : boundary.points) container.centre += p / static_cast<double>(boundary.points.size());
  } else if (!boundary.normal.isZero(0)) {
    container.centre = boundary.point;
  } else {
    container.unknown = "the snapshot does not tell where cylinder '" + boundary.name + "' stands";
    return;
  }
  const BoxRegion box = bounds(container.column(0, domain.min[container.axis], domain.max[container.axis]));
  const double slack = rounding * container.radius;
  for (int k = 0; k < 3; ++k) {
    if (box.min[k] >= domain.min[k] - slack && box.max[k] <= domain.max[k] + slack) continue;
    container.unknown = "cylinder '" + boundary.name + "' reaches out of the domain";
  }
}

void take_box(Container& container, const BoundaryRecord& boundary) {
  const int u = (container.axis + 1) % 3, v = (container.axis + 2) % 3;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : boundary.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double area = (high[u] - low[u]) * (high[v] - low[v]);
  if (!(std::abs(area / boundary.cross_section - 1) < rounding)) {
    container.unknown = "boundary '" + boundary.name + "' is no box along the axes";
    return;
  }
  for (int k : {u, v}) {
    container.min[k] = std::max(container.min[k], low[k]);
    container.max[k] = std::min(container.max[k], high[k]);
    container.walled[k] = true;
  }
}

/// Takes off what lies behind planes across the rectangle's axes.
void clip_by_planes(Container& container, const Snapshot& snapshot) {
  for (const BoundaryRecord& boundary : snapshot.boundaries) {
    if (boundary.kind != "plane") continue;
    for (int k = 0; k < 3; ++k) {
      if (k == container.axis || std::abs(boundary.normal[k]) < upright) continue;
      container.walled[k] = true;
      if (boundary.normal[k] > 0) container.min[k] = std::max(container.min[k], boundary.point[k]);
      if (boundary.normal[k] < 0) container.max[k] = std::min(container.max[k], boundary.point[k]);
    }
  }
}

}  // namespace

double Container::half_width() const {
  if (round) return radius;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (walled[k]) least = std::min(least, (max[k] - min[k]) / 2);
  }
  return std::isfinite(least) ? std::max(least, 0.0) : 0;
}

double Container::wall_distance(const Vec3& point) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (round) return radius - std::hypot(point[u] - centre[u], point[v] - centre[v]);
  double least = std::numeric_limits<double>::infinity();
  for (int k : {u, v}) {
    if (walled[k]) least = std::min({least, point[k] - min[k], max[k] - point[k]});
  }
  return least;
}

RegionShape Container::column(double distance, double lower, double upper) const {
  if (round) {
    return RingRegion{.axis = axis,
                      .centre = centre,
                      .inner = 0,
                      .outer = std::max(0.0, radius - distance),
                      .lower = lower,
                      .upper = upper};
  }
  BoxRegion box{min, max};
  for (int k = 0; k < 3; ++k) {
    if (!walled[k]) continue;
    box.min[k] += distance;
    box.max[k] -= distance;
  }
  return between(box, axis, lower, upper);
}

Container container_of(const Snapshot& snapshot, const BedFrame& frame) {
  Container container;
  container.axis = frame.axis;
  container.min = snapshot.domain.min;
  container.max = snapshot.domain.max;
  for (int k = 0; k < 3; ++k) container.walled[k] = k != frame.axis && !snapshot.domain.periodic[k];
  container.boundary = narrowest(snapshot, frame.axis);
  if (container.boundary) {
    const BoundaryRecord& boundary = snapshot.boundaries[*container.boundary];
    if (boundary.kind == "cylinder") {
      take_cylinder(container, boundary, snapshot.domain);
      return container;
    }
    take_box(container, boundary);
  }
  clip_by_planes(container, snapshot);
  container.centre = (container.min + container.max) / 2;
  return container;
}

}  // namespace packstone::analysis
