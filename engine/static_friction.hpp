// Which laws hold a load at rest.
#pragma once

#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/filling/population.hpp"

namespace packstone::engine {

/// Warns where particles are to rest under gravity on friction that cannot hold: coulomb, which chatters, and
/// haff-werner, which creeps at the load over its coefficient (tests/engine/test_slope.cpp).
void warn_without_static_friction(const Scene& scene, const Population& population, std::vector<std::string>& warnings);

}  // namespace packstone::engine
