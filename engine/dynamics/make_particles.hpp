// From the state a filling leaves to the state the steps work on.
#pragma once

#include "core/scene.hpp"
#include "engine/dynamics/particles.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// Masses and moments of inertia are those of solid spheres of full size and the material's density. Starting
/// velocities are taken as those half a step before time 0, where the leapfrog scheme keeps them; the
/// particles hold them apart from what contacts see unless the scene's contact_velocity is half_step.
Particles make_particles(const Scene& scene, const StartingState& start);

/// More of them, with the ids that follow; the list must be built anew before anything else.
void append_particles(Particles& particles, const Scene& scene, const StartingState& more);

}  // namespace packstone::engine
