#include "viz/slice.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
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

}  // namespace

void check_plane(const Domain& domain, const SlicePlane& plane) {
  if (!section(domain, plane).empty()) return;
  if (!plane.axis) throw InputError(fmt::format("the plane, {}, misses the domain", plane_text(plane)));
  const int k = *plane.axis;
  throw InputError(fmt::format("the plane {} misses the domain, which spans {} to {}", plane_text(plane),
                               length_text(domain.min[k]), length_text(domain.max[k])));
}

std::vector<Disc> slice_discs(const Snapshot& snapshot, const SlicePlane& plane) {
  check_plane(snapshot.domain, plane);
  const std::vector<InPlane> corners = section(snapshot.domain, plane);
  const std::vector<Vec3> shifts = image_shifts(snapshot.domain);
  std::vector<Disc> discs;
  for (std::size_t row = 0; row < snapshot.size(); ++row) {
    const double r = snapshot.radius[row];
    for (const Vec3& shift : shifts) {
      const Vec3 centre = snapshot.position[row] + shift;
      const double h = plane.height(centre);
      if (std::abs(h) >= r) continue;
      const InPlane place = plane.place(centre);
      const double radius = std::sqrt(r * r - h * h);
      if (distance_from(corners, place) < radius) discs.push_back({place.u, place.v, radius, row});
    }
  }
  return discs;
}

}  // namespace packstone::viz
