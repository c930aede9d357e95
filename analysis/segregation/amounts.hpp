// How much of its type every particle counts for: one, its volume or its mass.
#pragma once

#include <string>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/species.hpp"

namespace packstone::analysis {

struct Amounts {
  ShareBy by = ShareBy::volume;
  std::vector<double> of;          ///< (N) of a particle: 1, [m3] or [kg]
  std::vector<double> by_species;  ///< (species) of a type's particles together
  double total = 0;
  bool linked = false;  ///< to the type, SpeciesList::linked: labels cannot change places without the amounts

  double share(std::size_t s) const { return by_species[s] / total; }
  std::string noun() const;  ///< "number", "volume" or "mass"
};

Amounts amounts_of(const Snapshot& snapshot, const SpeciesList& list, ShareBy by);

}  // namespace packstone::analysis
