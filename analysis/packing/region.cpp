#include "analysis/packing/region.hpp"

#include <cmath>
#include <numbers>

#include "analysis/packing/lens.hpp"
#include "analysis/packing/overlap_volume.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

double from_line(const RingRegion& ring, const Vec3& point) {
  const int u = (ring.axis + 1) % 3, v = (ring.axis + 2) % 3;
  return std::hypot(point[u] - ring.centre[u], point[v] - ring.centre[v]);
}

double volume_of(const BoxRegion& box) { return (box.max - box.min).cwiseMax(0).prod(); }
double volume_of(const SphereRegion& sphere) { return sphere_volume(sphere.radius); }
double volume_of(const RingRegion& ring) {
  return std::numbers::pi * (ring.outer - ring.inner) * (ring.outer + ring.inner) * (ring.upper - ring.lower);
}

double volume_in(const BoxRegion& box, const Vec3& centre, double radius) {
  return sphere_box_volume(centre, radius, box.min, box.max);
}
double volume_in(const SphereRegion& sphere, const Vec3& centre, double radius) {
  return lens_volume(sphere.radius, radius, sphere.radius + radius - (centre - sphere.centre).norm());
}
double volume_in(const RingRegion& ring, const Vec3& centre, double radius) {
  const double height = centre[ring.axis];
  CylinderPart part{from_line(ring, centre), ring.outer, ring.lower - height, ring.upper - height};
  const double outer = sphere_cylinder_volume(radius, part);
  part.radius = ring.inner;
  return std::max(0.0, outer - sphere_cylinder_volume(radius, part));
}

bool holds(const BoxRegion& box, const Vec3& p) {
  return (p - box.min).minCoeff() >= 0 && (box.max - p).minCoeff() > 0;
}
bool holds(const SphereRegion& sphere, const Vec3& p) { return (p - sphere.centre).norm() < sphere.radius; }
bool holds(const RingRegion& ring, const Vec3& p) {
  const double s = from_line(ring, p), height = p[ring.axis];
  return s >= ring.inner && s < ring.outer && height >= ring.lower && height < ring.upper;
}

BoxRegion box_about(const BoxRegion& box) { return box; }
BoxRegion box_about(const SphereRegion& sphere) {
  const Vec3 reach = Vec3::Constant(sphere.radius);
  return {sphere.centre - reach, sphere.centre + reach};
}
BoxRegion box_about(const RingRegion& ring) {
  const Vec3 reach = Vec3::Constant(ring.outer);
  BoxRegion box{ring.centre - reach, ring.centre + reach};
  box.min[ring.axis] = ring.lower;
  box.max[ring.axis] = ring.upper;
  return box;
}

}  // namespace

double region_volume(const RegionShape& region) {
  return std::visit([](const auto& shape) { return volume_of(shape); }, region);
}

double volume_in_region(const RegionShape& region, const Vec3& centre, double radius) {
  return std::visit([&](const auto& shape) { return volume_in(shape, centre, radius); }, region);
}

bool contains(const RegionShape& region, const Vec3& point) {
  return std::visit([&](const auto& shape) { return holds(shape, point); }, region);
}

BoxRegion bounds(const RegionShape& region) {
  return std::visit([](const auto& shape) { return box_about(shape); }, region);
}

RegionShape between(RegionShape region, int axis, double lower, double upper) {
  if (auto* box = std::get_if<BoxRegion>(&region)) {
    box->min[axis] = lower;
    box->max[axis] = upper;
  } else if (auto* ring = std::get_if<RingRegion>(&region)) {
    ring->lower = lower;
    ring->upper = upper;
  }
  return region;
}

}  // namespace packstone::analysis
