// How the particles come in: the one place where filling.kind becomes code.
#pragma once

#include <vector>

#include "core/scene.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// Throws InputError, located in the scene or in the file, when the particles cannot come in as the scene asks.
StartingState fill(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

}  // namespace packstone::engine
