#include <ratio>

#include "engine/contact/chosen_normal.hpp"
#include "engine/dynamics/central_forces.hpp"

namespace packstone::engine {

std::unique_ptr<ForceField> make_hertz_forces(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  return std::make_unique<CentralForces<ChosenNormal, std::ratio<3, 2>>>(scene, domain, boundaries);
}

}  // namespace packstone::engine
