// Filling from a file: the particles are where a table, another program or an earlier run left them.
#pragma once

#include <vector>

#include "core/scene.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// The particles of filling.path in ascending order of their ids, numbered anew from 0, at full size. Every one is a
/// finite sphere of a group of the scene, inside the domain but for open faces and periodic sides (at most a
/// domain's length outside), with its centre in front of every plane. Throws InputError at the file's line.
StartingState particles_from_file(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

}  // namespace packstone::engine
