#include "engine/filling/filling.hpp"

#include "engine/filling/file_filling.hpp"
#include "engine/filling/growth.hpp"

namespace packstone::engine {

StartingState fill(const Scene& scene, const Domain& domain, const std::vector<Plane>& planes) {
  if (scene.filling.kind == FillingKind::file) return particles_from_file(scene, domain, planes);
  check_growth_volume(scene, domain);
  return grown_particles(scene, domain, planes);
}

}  // namespace packstone::engine
