#include "viz/slice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "viz/camera.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

namespace {

/// The shifts of a particle that may bring it to where it is seen: itself and its nearest images.
std::vector<Vec3> image_shifts(const Domain& domain) {
  std::vector<Vec3> shifts = {Vec3::Zero()};
  for (int k = 0; k < 3; ++k) {
    if (!domain.periodic[k]) continue;
    const Vec3 period = (domain.max[k] - domain.min[k]) * Vec3::Unit(k);
    std::vector<Vec3> more;
    for (const Vec3& shift : shifts) more.insert(more.end(), {shift - period, shift, shift + period});
    shifts = more;
  }
  return shifts;
}

/// Those shifts that bring some of a box to the plane.
std::vector<Vec3> shifts_to(const SlicePlane& plane, const Region& box, const std::vector<Vec3>& shifts) {
  std::vector<Vec3> near;
  for (const Vec3& shift : shifts) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& corner : box_corners(box.min, box.max)) {
      low = std::min(low, plane.height(corner + shift));
      high = std::max(high, plane.height(corner + shift));
    }
    const double rounding = 1e-9 * (high - low);
    if (low <= rounding && high >= -rounding) near.push_back(shift);
  }
  return near;
}

}  // namespace

void check_plane(const Domain& domain, const SlicePlane& plane) {
  if (!section(domain, plane).empty()) return;
  if (!plane.axis) throw InputError(fmt::format("the plane, {}, misses the domain", plane_text(plane)));
  const int k = *plane.axis;
  throw InputError(fmt::format("the plane {} misses the domain, which spans {} to {}", plane_text(plane),
                               length_text(domain.min[k]), length_text(domain.max[k])));
}

std::vector<Disc> slice_discs(const ParticleView& particles, const SlicePlane& plane) {
  const Domain& domain = particles.snapshot->domain;
  check_plane(domain, plane);
  const std::vector<InPlane> corners = section(domain, plane);
  const std::vector<Vec3> shifts = image_shifts(domain);
  std::vector<Disc> discs;
  for (const RowChunk& chunk : chunks_of(particles)) {
    const std::vector<Vec3> near = shifts_to(plane, chunk.box, shifts);
    if (near.empty()) continue;
    check_rows(particles, chunk);
    for (std::size_t row = chunk.first; row < chunk.last; ++row) {
      const double r = particles.radius[row];
      for (const Vec3& shift : near) {
        const Vec3 centre = particles.position[row] + shift;
        const double h = plane.height(centre);
        if (std::abs(h) >= r) continue;
        const InPlane place = plane.place(centre);
        const double radius = std::sqrt(r * r - h * h);
        if (distance_from(corners, place) < radius) discs.push_back({place.u, place.v, radius, row});
      }
    }
  }
  return discs;
}

}  // namespace packstone::viz
