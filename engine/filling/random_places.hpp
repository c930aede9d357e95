// Filling a region with spheres at random places that do not overlap.
#pragma once

#include <vector>

#include "core/scene.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// All particles at rest, the largest placed first, each at a uniformly random place where it touches none before
/// (random sequential addition); O(N) whatever the ratio of sizes. Throws InputError that says how many found a place:
/// equal spheres stop near a fraction of 0.38 (Torquato, Random Heterogeneous Materials (2002)), and well before it is
/// slow.
StartingState randomly_placed_particles(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

}  // namespace packstone::engine
