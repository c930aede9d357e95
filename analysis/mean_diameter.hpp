// Mean diameter weighted by volume.
#pragma once

#include <span>

namespace packstone::analysis {

/// sum d^4 / sum d^3 [m] (De Brouckere): a few large particles among many fine ones order the bed at a wall, and ask
/// for room in a cell, over their own size. radius: (N) [m]. 0 without solid.
double volume_mean_diameter(std::span<const double> radius);

}  // namespace packstone::analysis
