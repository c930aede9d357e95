// What sizes the particles of a scene really have: groups of a file hold many radii, groups that grow one each.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// Particles of one [[particles]] entry.
struct GroupSizes {
  std::int64_t count = 0;
  double smallest_radius = 0;  ///< at full size [m]; 0 without particles
  double largest_radius = 0;   ///< [m]
};

/// One entry a group of the scene, in its order.
using Population = std::vector<GroupSizes>;

Population population_of(const Scene& scene, const StartingState& start);

/// Over all groups [m].
double largest_radius(const Population& population);

/// Of all particles [m]; infinite without any.
double smallest_radius(const Population& population);

}  // namespace packstone::engine
