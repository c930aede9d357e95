// The parts of the measure "structure": each adds its quantities and tables, the same ones for every snapshot.
#pragma once

#include "analysis/context.hpp"
#include "analysis/result.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// Coordination numbers: means, distribution, rattlers, by types.
void add_coordination(MeasureResult& result, const Snapshot& snapshot, const Context& context);

/// Fabric tensor of the contacts.
void add_fabric(MeasureResult& result, const Snapshot& snapshot, const Context& context);

/// Radial distribution function. Throws InputError when the options ask for too many bins.
void add_pair_distribution(MeasureResult& result, const Snapshot& snapshot, const Context& context);

/// Bond-orientational order.
void add_bond_order(MeasureResult& result, const Snapshot& snapshot, const Context& context);

}  // namespace packstone::analysis
