#include "engine/filling/placing.hpp"

#include <algorithm>

namespace packstone::engine {

Region region_of(const Scene& scene, const Domain& domain) {
  return {scene.filling.region_min.value_or(domain.min), scene.filling.region_max.value_or(domain.max)};
}

bool has_room(const Vec3& p, double radius, const Region& region, const Domain& domain, const Boundaries& boundaries) {
  constexpr double rounding = 1e-12;  // of the radius: spheres may touch
  const double reach = radius * (1 - rounding);
  for (int axis = 0; axis < 3; ++axis) {
    const bool whole_period =
        domain.periodic[axis] && region.min[axis] == domain.min[axis] && region.max[axis] == domain.max[axis];
    if (whole_period) continue;
    if (p[axis] - reach < region.min[axis] || p[axis] + reach > region.max[axis]) return false;
  }
  return boundaries.leave_room(p, reach);
}

StartingState unplaced_particles(const Scene& scene) {
  StartingState start;
  for (std::size_t g = 0; g < scene.particles.size(); ++g) {
    for (const double radius : scene.radii(g)) {
      start.radius.push_back(radius);
      start.type.push_back(static_cast<std::int32_t>(g));
    }
  }
  start.position.assign(start.radius.size(), Vec3::Zero());
  start.velocity = start.angular_velocity = start.position;
  return start;
}

}  // namespace packstone::engine
