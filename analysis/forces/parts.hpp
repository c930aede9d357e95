// The parts of the measure "forces": each adds its quantities and tables. Without forces the quantities are there
// without value, with network.missing as the reason, and the tables are empty.
#pragma once

#include "analysis/context.hpp"
#include "analysis/forces/force_network.hpp"
#include "analysis/result.hpp"

namespace packstone::analysis {

/// Thickness wanted for the layers of profiles [m]; 0 where all radii are 0.
inline double profile_thickness(const Context& context) {
  return context.options.profile_layer > 0 ? context.options.profile_layer : context.mean_radius;
}

/// Distribution of normal and tangential forces, its tail, and friction.
void add_force_distribution(MeasureResult& result, const Snapshot& snapshot, const ForceNetwork& network);

/// Stress of the bulk, of horizontal layers and of the particles.
void add_stress(MeasureResult& result, const Snapshot& snapshot, const Context& context, const ForceNetwork& network);

/// Coarse-grained density, velocity and stress.
void add_coarse_fields(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                       const ForceNetwork& network);

/// Force chains.
void add_force_chains(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                      const ForceNetwork& network);

/// The k-cores of the network of contacts; needs no forces.
void add_cores(MeasureResult& result, const Snapshot& snapshot, const Context& context);

}  // namespace packstone::analysis
