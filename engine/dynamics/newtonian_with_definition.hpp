// The definition behind newtonian_with.hpp, for the files that instantiate it.
#pragma once

#include "engine/contact/frictionless.hpp"
#include "engine/dynamics/newtonian_step.hpp"
#include "engine/dynamics/newtonian_with.hpp"
#include "engine/dynamics/precision.hpp"
#include "engine/simd/lanes.hpp"

namespace packstone::engine {

template <class Normal, class Tangential, class Precision>
std::unique_ptr<Dynamics> newtonian_with(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  if (rotates(scene)) {
    return std::make_unique<NewtonianStep<Precision, Normal, Tangential>>(scene, domain, boundaries);
  }
  return std::make_unique<NewtonianStep<Precision, Normal, Frictionless>>(scene, domain, boundaries);
}

}  // namespace packstone::engine
