#include <ratio>

#include "engine/contact/linear.hpp"
#include "engine/dynamics/central_forces.hpp"

namespace packstone::engine {

std::unique_ptr<ForceField> make_linear_forces(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  return std::make_unique<CentralForces<Linear<Release::zero_overlap>, std::ratio<1>>>(scene, domain, boundaries);
}

}  // namespace packstone::engine
