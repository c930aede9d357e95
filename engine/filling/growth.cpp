#include "engine/filling/growth.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/random.hpp"
#include "engine/filling/placing.hpp"

namespace packstone::engine {

namespace {

constexpr double random_close_packing = 0.64;  ///< equal spheres, Scott & Kilgour, J. Phys. D 2 (1969) 863: 0.6366
/// Small spheres filling the gaps of large ones (Furnas' limit).
constexpr double binary_close_packing = 1 - (1 - random_close_packing) * (1 - random_close_packing);
/// Below this ratio of radii small spheres do not fit into the gaps, and mixtures pack much as equal spheres do.
constexpr double gap_filling_ratio = 2.0;
constexpr int placement_trials = 1000;

Vec3 random_position(const Scene& scene, const Domain& domain, const Boundaries& boundaries, std::int64_t id) {
  const auto [low, high] = region_of(scene, domain);
  Random random(static_cast<std::uint64_t>(scene.seed), RandomStream::filling_position, static_cast<std::uint64_t>(id));
  for (int trial = 0; trial < placement_trials; ++trial) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = random.uniform(low[k], high[k]);
    if (boundaries.leave_room(p, 0)) return p;
  }
  scene.fail("filling", fmt::format("no place for particle {}: the boundaries cut off nearly all of the region; check "
                                    "each boundary's point and the direction of its normal",
                                    id));
}

}  // namespace

void check_growth_volume(const Scene& scene, const Domain& domain) {
  SizeRange sizes = scene.size_range(0);
  for (std::size_t g = 1; g < scene.particles.size(); ++g) {
    const SizeRange own = scene.size_range(g);
    sizes = {std::min(sizes.smallest, own.smallest), std::max(sizes.largest, own.largest)};
  }
  const double limit = sizes.largest > gap_filling_ratio * sizes.smallest ? binary_close_packing : random_close_packing;
  const Region region = region_of(scene, domain);
  const double room = (region.max - region.min).prod();
  const double solid = scene.solid_volume();
  if (solid > limit * room) {
    scene.fail(
        "filling",
        fmt::format("the particles' {:.4g} m3 do not fit into the region's {:.4g} m3: a fraction of {:.2f}, and a "
                    "random packing reaches about {:.2f}; enlarge the domain to at least {:.4g} m3 or take fewer "
                    "particles",
                    solid, room, solid / room, limit, solid / limit));
  }
}

StartingState grown_particles(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  StartingState start;
  for (std::size_t g = 0; g < scene.particles.size(); ++g) {
    for (const double radius : scene.radii(g)) {
      const auto id = static_cast<std::int64_t>(start.size());
      start.position.push_back(random_position(scene, domain, boundaries, id));
      start.radius.push_back(radius);
      start.type.push_back(static_cast<std::int32_t>(g));
    }
  }
  start.velocity.assign(start.size(), Vec3::Zero());
  start.angular_velocity.assign(start.size(), Vec3::Zero());
  return start;
}

Growth growth_at(const Scene& scene, double time) {
  const double duration = scene.filling.over();
  if (time >= duration) return {1, 0};
  return {time / duration, 1 / duration};
}

}  // namespace packstone::engine
