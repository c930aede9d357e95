// The types of particles that occur, with what the mixing measures need of each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone::analysis {

struct Species {
  std::int32_t type = 0;  ///< index into the snapshot's groups
  std::string name;
  std::size_t count = 0;
  double volume = 0;   ///< of its particles together [m3]
  double density = 0;  ///< [kg/m3]
};

struct SpeciesList {
  std::vector<Species> species;     ///< types that occur, ascending
  std::vector<std::int32_t> label;  ///< (N) index into species
  double volume = 0;                ///< of all particles [m3]

  std::size_t size() const { return species.size(); }
  double share(std::size_t s) const { return species[s].volume / volume; }  ///< of the solid volume

  /// Whether particles of one type differ in size from those of another (linked(), by volume). Then exchanging labels
  /// would also exchange sizes, and is no model of random mixing.
  bool size_linked() const;

  /// Whether an amount that every particle has depends on its type: some type's mean is more than 10 % off the mean of
  /// all. by_species: (species) sum over the type's particles.
  bool linked(const std::vector<double>& by_species) const;

  /// "0 light, 1 heavy", for captions.
  std::string legend() const;
};

SpeciesList species_of(const Snapshot& snapshot);

}  // namespace packstone::analysis
