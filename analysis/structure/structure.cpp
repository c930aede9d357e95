// Measure "structure": contacts, their directions, and how the particles lie around each other.
#include "analysis/measures.hpp"
#include "analysis/structure/parts.hpp"

namespace packstone::analysis {

MeasureResult measure_structure(const Snapshot& snapshot, const Context& context) {
  MeasureResult result{.name = "structure"};
  add_coordination(result, snapshot, context);
  add_fabric(result, snapshot, context);
  add_pair_distribution(result, snapshot, context);
  add_bond_order(result, snapshot, context);
  return result;
}

}  // namespace packstone::analysis
