// From a [[boundary]] of the scene to its shape.
#pragma once

#include "core/scene.hpp"
#include "engine/boundary/shape.hpp"

namespace packstone::engine {

/// Throws InputError located in the scene or the file.
Shape make_shape(const Scene& scene, std::size_t boundary, const Domain& domain);

}  // namespace packstone::engine
