// What presses contacts: falls, and the bed's own weight.
#pragma once

#include "core/scene.hpp"
#include "engine/filling/population.hpp"

namespace packstone::engine {

/// Extent of a box along gravity [m]; size: of the box [m].
double fall_height(const Scene& scene, const Vec3& size);

/// After a fall through the box [m/s]; 0 without gravity.
double fall_speed(const Scene& scene, const Vec3& size);

/// Overlap at the bottom of the bed, a column's weight on one contact, over the radius; 0 without gravity.
/// solid_volume: of all particles [m3].
double resting_overlap(const Scene& scene, const Population& population, const Vec3& size, double solid_volume);

}  // namespace packstone::engine
