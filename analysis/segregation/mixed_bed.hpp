// What the segregation measure knows of a bed, worked out once: types, amounts, compartments, contacts.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/segregation/amounts.hpp"
#include "analysis/segregation/composition.hpp"
#include "analysis/segregation/division.hpp"
#include "analysis/species.hpp"

namespace packstone::analysis {

/// Divisions of the whole bed that have indices of their own.
enum Part : std::size_t { layers_part, rings_part, cells_part, part_count };

/// A division of the bed, and what lies in it.
struct DividedBed {
  Division division;
  std::string missing = {};      ///< why it says nothing; empty where it does
  Composition composition = {};  ///< as found; empty where the division is missing
};

struct MixedBed {
  const Snapshot& snapshot;
  const Context& context;
  SpeciesList list;
  BedFrame frame;  ///< along the chosen axis
  Amounts amounts;
  std::string missing = {};  ///< why there is nothing to mix; empty where there is. Then nothing below is set
  Layers layers = {};
  Rings rings = {};
  std::array<DividedBed, part_count> parts = {};
  std::vector<CellGrid> grids = {};   ///< of all scales of scrutiny
  std::vector<Division> scales = {};  ///< in their cells
  std::size_t scarcest = 0;           ///< species of the smallest share

  /// s0^2 summed over the species, of a separated bed.
  double separated_variance() const;
  /// Largest distance of two types' centres over the length of a uniform bed in which the types lie one on another.
  double separated_distance() const;
};

MixedBed mixed_bed(const Snapshot& snapshot, const Context& context);

}  // namespace packstone::analysis
