// Newton's equations with one normal and one tangential law, or frictionless, in one precision. Each normal law and
// precision is compiled in its own file, newtonian_LAW.cpp or newtonian_LAW_mixed.cpp: every combination is a loop of
// its own.
#pragma once

#include <memory>
#include <vector>

#include "core/scene.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

/// Tangential: the law where the scene has friction. Precision: DoublePrecision or MixedPrecision of the widest lanes.
template <class Normal, class Tangential, class Precision>
std::unique_ptr<Dynamics> newtonian_with(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

}  // namespace packstone::engine
