// Newton's equations with one normal law and the scene's tangential law. Each normal law is compiled in its own file,
// newtonian_LAW.cpp: every combination is a loop of its own.
#pragma once

#include <memory>
#include <vector>

#include "core/scene.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

template <class Normal>
std::unique_ptr<Dynamics> newtonian_with(const Scene& scene, const Domain& domain, const std::vector<Plane>& planes);

}  // namespace packstone::engine
