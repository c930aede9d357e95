// What the fillings share that place particles of given sizes in a region.
#pragma once

#include <string>
#include <vector>

#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// filling.region, the domain unless given [m].
Region region_of(const Scene& scene, const Domain& domain);

/// Whether a sphere of this radius at p lies within the region, but for periodic sides, and in front of every plane.
bool has_room(const Vec3& p, double radius, const Region& region, const Domain& domain, const Boundaries& boundaries);

/// All particles of all groups, ids following the groups, at rest at the origin.
StartingState unplaced_particles(const Scene& scene);

}  // namespace packstone::engine
