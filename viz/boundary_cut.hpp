// The lines in which a slice cuts the boundaries.
#pragma once

#include <vector>

#include "core/snapshot.hpp"
#include "viz/slice_plane.hpp"

namespace packstone::viz {

/// Points (u, v) [m] along the axes in the plane. A line that closes ends where it begins.
using CutLine = std::vector<InPlane>;

/// Every line that may reach into the domain. Planes are cut off at the domain's sides, and left out where they are
/// such a side, as it is drawn anyway; surfaces are whole. What lies in the slice's plane is not cut. Periodic images
/// are left out.
std::vector<CutLine> boundary_cut(const Snapshot& snapshot, const SlicePlane& plane);

}  // namespace packstone::viz
