// Keys of a scene against each other; each key by itself has been checked as it was read.
#pragma once

#include "core/options.hpp"
#include "core/scene.hpp"

namespace packstone {

/// Names of choices, which messages list too.
extern const ChoiceNames axes, faces, normal_laws, tangential_laws;

/// Throws InputError located at the key that is wrong.
void check(const Scene& scene);

/// The part of it that knows which material keys the scene's laws need.
void check_materials(const Scene& scene);

/// The part of it that knows what goes with overdamped motion, and what only with it.
void check_motion_kind(const Scene& scene);

}  // namespace packstone
