// All maps in one list.
#include <fmt/format.h>

#include "cli/study/map_parts.hpp"

namespace packstone::cli {

std::vector<StabilityMap> stability_maps(bool quick) {
  std::vector<StabilityMap> maps = step_maps();
  const std::string spring = fmt::format("tangential_stiffness = {}", bead_stiffness);
  for (const StabilityMap& map :
       {growth_map(), jitter_map(), creep_map("cundall_strack", "cundall-strack", spring),
        creep_map("coulomb", "coulomb", ""), creep_map("haff_werner", "haff-werner", "tangential_damping = 1"),
        adhesion_map(), size_map(), load_map(), overdamped_map(), precision_map(), wall_map()}) {
    maps.push_back(map);
  }
  if (!quick) return maps;
  for (StabilityMap& map : maps) {
    for (auto* values : {&map.x, &map.y}) {
      std::vector<double> coarse;
      for (std::size_t k = 0; k < values->size(); k += 2) coarse.push_back((*values)[k]);
      *values = coarse;
    }
  }
  return maps;
}

}  // namespace packstone::cli
