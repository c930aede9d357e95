#include "analysis/packing/interior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/mean_diameter.hpp"

namespace packstone::analysis {

namespace {

constexpr double surface_square = 2;      // diameters; narrower ones may hold no sphere of the surface
constexpr double level_normal = 1e-9;     // component along up of a normal below which a plane has no height
constexpr double margin_rounding = 1e-9;  // of the margin

struct Heights {
  double lower, upper;  // above the floor [m]
};

/// What interior_of works with.
struct Bed {
  const Snapshot& snapshot;
  const BedFrame& frame;
  const Container& container;
  double margin;

  double height_of(double coordinate) const { return frame.sign * (coordinate - frame.floor); }
  double coordinate_of(double height) const { return frame.floor + frame.sign * height; }

  RegionShape column(double distance, const Heights& h) const {
    const auto [low, high] = std::minmax({coordinate_of(h.lower), coordinate_of(h.upper)});
    return container.column(distance, low, high);
  }
};

/// Height of the highest sphere in each square of the column's cross-section; the least of them.
double lowest_surface(const Bed& bed, double diameter) {
  const int u = (bed.frame.axis + 1) % 3, v = (bed.frame.axis + 2) % 3;
  const RegionShape column = bed.column(bed.margin, {0, 1});
  const BoxRegion box = bounds(column);
  const Vec3 size = box.max - box.min;
  // No more squares than particles.
  const double width =
      std::max(surface_square * diameter, std::sqrt(size[u] * size[v] / static_cast<double>(bed.snapshot.size())));
  const auto across = [&](int k) { return std::max(1.0, std::floor(size[k] / width)); };
  const double nu = across(u), nv = across(v);
  std::vector<double> top(static_cast<std::size_t>(nu * nv), 0.0);
  for (std::size_t i = 0; i < bed.snapshot.size(); ++i) {
    const Vec3 p = bed.snapshot.domain.wrapped(bed.snapshot.position[i]);
    const double a = std::floor((p[u] - box.min[u]) / size[u] * nu), b = std::floor((p[v] - box.min[v]) / size[v] * nv);
    if (!(a >= 0 && a < nu && b >= 0 && b < nv)) continue;
    double& highest = top[static_cast<std::size_t>(a * nv + b)];
    highest = std::max(highest, bed.frame.height[i] + bed.snapshot.radius[i]);
  }
  double least = std::numeric_limits<double>::infinity();
  for (double a = 0; a < nu; ++a) {
    for (double b = 0; b < nv; ++b) {
      Vec3 middle = Vec3::Zero();
      middle[u] = box.min[u] + (a + 0.5) / nu * size[u];
      middle[v] = box.min[v] + (b + 0.5) / nv * size[v];
      middle[bed.frame.axis] = (box.min[bed.frame.axis] + box.max[bed.frame.axis]) / 2;
      if (contains(column, middle)) least = std::min(least, top[static_cast<std::size_t>(a * nv + b)]);
    }
  }
  return least;
}

/// Least value of n . x over the column's cross-section, n without its component along up.
double least_sideways(const RegionShape& column, int axis, Vec3 n) {
  n[axis] = 0;
  if (const auto* ring = std::get_if<RingRegion>(&column)) return n.dot(ring->centre) - n.norm() * ring->outer;
  const auto& box = std::get<BoxRegion>(column);
  return n.cwiseProduct(box.min).cwiseMin(n.cwiseProduct(box.max)).sum();
}

/// Leaves what is far enough from a plane. False where it cuts the column from top to bottom.
bool keep_from_plane(Heights& h, const Bed& bed, const BoundaryRecord& plane) {
  const RegionShape column = bed.column(bed.margin, {0, 1});
  const double sideways = least_sideways(column, bed.frame.axis, plane.normal);
  const double along = bed.frame.sign * plane.normal[bed.frame.axis];
  // The plane's normal times x, with the coordinate along up counted from the floor.
  const double floor_part = plane.normal[bed.frame.axis] * bed.frame.floor;
  const double missing = plane.normal.dot(plane.point) + bed.margin - sideways - floor_part;
  if (along > level_normal) h.lower = std::max(h.lower, missing / along);
  if (along < -level_normal) h.upper = std::min(h.upper, missing / along);
  return std::abs(along) > level_normal || missing <= margin_rounding * bed.margin;
}

BoxRegion box_about(const std::vector<Vec3>& points) {
  BoxRegion box{points.front(), points.front()};
  for (const Vec3& p : points) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  return box;
}

/// Whether an upright cylinder or box stands about the whole column, so that its sides are behind the container's.
bool encloses(const BoundaryRecord& boundary, const BoxRegion& about, const Bed& bed) {
  if (std::abs(boundary.axis[bed.frame.axis]) < 1 - level_normal) return false;
  const BoxRegion column = bounds(bed.column(0, {0, 1}));
  const double slack = margin_rounding * bed.margin;
  const double radius = boundary.kind == "cylinder" ? std::sqrt(boundary.cross_section / std::numbers::pi) : 0;
  double corner = 0;  // distance of the column's farthest corner from the boundary's middle, squared
  for (int k = 0; k < 3; ++k) {
    if (k == bed.frame.axis) continue;
    if (about.min[k] > column.min[k] + slack || about.max[k] < column.max[k] - slack) return false;
    const double middle = (about.min[k] + about.max[k]) / 2;
    const double side = std::max(middle - column.min[k], column.max[k] - middle);
    corner += side * side;
  }
  return boundary.kind == "box" || bed.container.round || corner <= radius * radius;
}

/// Leaves the higher of the parts below and above a boundary, or the inside of one that encloses the column.
void keep_from_surface(Heights& h, const Bed& bed, const BoundaryRecord& boundary, bool own) {
  const BoxRegion about = box_about(boundary.points), column = bounds(bed.column(bed.margin, {0, 1}));
  const auto [bottom, top] =
      std::minmax({bed.height_of(about.min[bed.frame.axis]), bed.height_of(about.max[bed.frame.axis])});
  if (own || encloses(boundary, about, bed)) {
    if (boundary.kind == "box") h = {std::max(h.lower, bottom + bed.margin), std::min(h.upper, top - bed.margin)};
    return;
  }
  for (int k = 0; k < 3; ++k) {
    if (k == bed.frame.axis) continue;
    if (about.max[k] + bed.margin <= column.min[k] || about.min[k] - bed.margin >= column.max[k]) return;
  }
  const Heights below{h.lower, std::min(h.upper, bottom - bed.margin)};
  const Heights above{std::max(h.lower, top + bed.margin), h.upper};
  h = above.upper - above.lower >= below.upper - below.lower ? above : below;
}

/// Leaves what is far enough from every boundary that is no side of the container. A reason where that is nothing.
std::string keep_from_boundaries(Heights& h, const Bed& bed) {
  for (std::size_t b = 0; b < bed.snapshot.boundaries.size(); ++b) {
    const BoundaryRecord& boundary = bed.snapshot.boundaries[b];
    if (boundary.kind == "plane") {
      if (!boundary.normal.isZero(0) && !keep_from_plane(h, bed, boundary)) {
        return "plane '" + boundary.name + "' cuts the column between the side walls";
      }
      continue;
    }
    if (boundary.points.empty()) continue;
    keep_from_surface(h, bed, boundary, b == bed.container.boundary);
    if (!(h.upper > h.lower)) return "nothing is left beside boundary '" + boundary.name + "'";
  }
  return "";
}

Heights whole_height(const Bed& bed, const BedState& state, double diameter) {
  if (bed.frame.periodic) return {0, bed.frame.extent};
  const Domain& domain = bed.snapshot.domain;
  const auto [low, high] =
      std::minmax({bed.height_of(domain.min[bed.frame.axis]), bed.height_of(domain.max[bed.frame.axis])});
  const double surface = std::min(state.height, lowest_surface(bed, diameter));
  return {std::max(0.0, low) + bed.margin, std::min(surface, high) - bed.margin};
}

}  // namespace

Interior interior_of(const Snapshot& snapshot, const Context& context, const Container& container) {
  Interior interior;
  const double diameter = volume_mean_diameter(snapshot.radius);
  interior.margin = context.options.interior_margin * diameter;
  if (snapshot.size() == 0) {
    interior.reason = "no particles";
  } else if (!(diameter > 0)) {
    interior.reason = "all radii are 0";
  } else if (!container.unknown.empty()) {
    interior.reason = container.unknown;
  } else if (!context.frame.periodic && !(context.bed.height > 0)) {
    interior.reason = "all particles lie below the floor";
  }
  if (!interior.reason.empty()) return interior;

  const Bed bed{snapshot, context.frame, container, interior.margin};
  if (!(region_volume(bed.column(interior.margin, {0, 1})) > 0)) {
    interior.reason = "no place is so far from the side walls";
    return interior;
  }
  Heights heights = whole_height(bed, context.bed, diameter);
  interior.reason = keep_from_boundaries(heights, bed);
  if (interior.reason.empty() && !(heights.upper > heights.lower)) {
    interior.reason = "no place is so far from floor and surface";
  }
  if (interior.reason.empty()) interior.shape = bed.column(interior.margin, heights);
  return interior;
}

}  // namespace packstone::analysis
