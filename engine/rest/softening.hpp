// Softer contacts for the way to rest, where only the bed at rest is wanted.
#pragma once

#include "core/scene.hpp"
#include "engine/filling/population.hpp"

namespace packstone::engine {

/// How much softer a bed may be.
struct Softening {
  double factor = 1;           ///< on the stiffness of every material, 1 at most
  double resting_overlap = 0;  ///< at the bottom of the softened bed, over the radius
  double impact_overlap = 0;   ///< of a Newtonian fall through the domain, over the radius
};

/// The softest at which the bed's weight presses no contact by more than dynamics.way_overlap and no fall by more than
/// a tenth of the radius; without inertia nothing falls. solid_volume: of all particles [m3].
Softening softening(const Scene& scene, const Population& population, double solid_volume);

/// The scene with all stiffnesses times a factor, and damping such that restitutions stay.
Scene softened(Scene scene, double factor);

}  // namespace packstone::engine
