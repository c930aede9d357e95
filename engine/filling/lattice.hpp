// Filling a region with the sites of a lattice.
#pragma once

#include <vector>

#include "core/scene.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// All particles at rest on sites that have room for the largest of them, the lowest sites first (against gravity),
/// particles in random order. Along whole periodic sides the lattice is stretched to fit in a whole number of times.
/// Throws InputError that says how many fit.
StartingState lattice_particles(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

}  // namespace packstone::engine
