#include "engine/filling/random_places.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/geometry.hpp"
#include "core/random.hpp"
#include "engine/filling/placed_spheres.hpp"
#include "engine/filling/placing.hpp"

namespace packstone::engine {

namespace {

constexpr int most_tries = 20000;  ///< for one particle

}  // namespace

StartingState randomly_placed_particles(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  StartingState start = unplaced_particles(scene);
  std::vector<std::size_t> order(start.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return start.radius[a] > start.radius[b]; });
  PlacedSpheres placed(domain, start.radius[order.front()]);
  const Region region = region_of(scene, domain);
  double volume = 0;
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::size_t id = order[n];
    const double radius = start.radius[id];
    Random random(static_cast<std::uint64_t>(scene.seed), RandomStream::filling_position, id);
    bool found = false;
    for (int trial = 0; trial < most_tries && !found; ++trial) {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(region.min[axis], region.max[axis]);
      found = placed.touches_none(p, radius) && has_room(p, radius, region, domain, boundaries);
      if (found) start.position[id] = domain.wrapped(p);
    }
    if (!found) {
      scene.fail(
          "filling",
          fmt::format("{} of {} particles found a place without overlap, a solid fraction of {:.3f} of the "
                      "region; random places end near 0.38 for equal spheres: enlarge the region, take fewer, or "
                      "let them grow (kind = \"growth\")",
                      n, start.size(), volume / (region.max - region.min).prod()));
    }
    placed.add(start.position[id], radius);
    volume += sphere_volume(radius);
  }
  return start;
}

}  // namespace packstone::engine
