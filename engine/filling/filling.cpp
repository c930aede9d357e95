#include "engine/filling/filling.hpp"

#include "engine/filling/file_filling.hpp"
#include "engine/filling/growth.hpp"
#include "engine/filling/lattice.hpp"
#include "engine/filling/random_places.hpp"

namespace packstone::engine {

StartingState fill(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  switch (scene.filling.kind) {
    case FillingKind::file:
      return particles_from_file(scene, domain, boundaries);
    case FillingKind::lattice:
      return lattice_particles(scene, domain, boundaries);
    case FillingKind::random:
      return randomly_placed_particles(scene, domain, boundaries);
    case FillingKind::pour:
      return {};  // they come in over time: Pouring
    case FillingKind::growth:
      break;
  }
  check_growth_volume(scene, domain);
  return grown_particles(scene, domain, boundaries);
}

}  // namespace packstone::engine
