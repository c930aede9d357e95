// Parts of the measure "packing": solid fractions of regions, by distance from the walls, and on a grid.
#pragma once

#include "analysis/context.hpp"
#include "analysis/packing/container.hpp"
#include "analysis/packing/interior.hpp"
#include "analysis/result.hpp"

namespace packstone::analysis {

/// Table regions: one row for each of context.options.regions. Throws InputError (clipped).
void add_regions(MeasureResult& result, const Snapshot& snapshot, const Context& context);

/// Quantities interior_fraction, with its standard error over blocks, and interior_volume.
void add_interior(MeasureResult& result, const Snapshot& snapshot, const Context& context, const Interior& interior);

/// Tables radial_profile and wall_profile; without rows where the container has no such walls, and the caption says
/// why.
void add_wall_profiles(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                       const Container& container);

/// Quantities map_fraction_mean, map_fraction_deviation and map_cell.
void add_map(MeasureResult& result, const Snapshot& snapshot, const Context& context, const Container& container,
             const Interior& interior);

}  // namespace packstone::analysis
