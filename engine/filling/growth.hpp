// Growth filling, Zhong et al., Acta Phys. Sin. 58 (2009), section 6.1: centres at random, radii that grow from zero to
// full size while contacts push the particles apart. Masses are those of the full size throughout: one that vanished
// with the radius would make the contact time vanish and any fixed step unstable.
#pragma once

#include <vector>

#include "core/scene.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/dynamics/particles.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// Refuses to grow more volume than a random packing in the region holds. Throws InputError.
void check_growth_volume(const Scene& scene, const Domain& domain);

/// All particles at rest at random positions in the region, on the inner side of every plane. Ids follow the groups.
/// Throws InputError when the boundaries leave no room.
StartingState grown_particles(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

/// Share of full size and its rate at a time [s]; full size throughout where nothing grows.
Growth growth_at(const Scene& scene, double time);

}  // namespace packstone::engine
