// The part of a bed away from walls, floor and surface.
#pragma once

#include <optional>
#include <string>

#include "analysis/context.hpp"
#include "analysis/packing/container.hpp"
#include "analysis/packing/region.hpp"

namespace packstone::analysis {

/// Where the bed is neither ordered by a wall nor loosened by its surface.
struct Interior {
  double margin = 0;                 ///< distance kept from walls, floor and surface [m]
  std::optional<RegionShape> shape;  ///< an upright column
  std::string reason;                ///< why there is none
};

/// The container's column at least context.options.interior_margin volume-mean diameters from
/// - the side walls;
/// - the floor, every plane (also a tilted one), and the domain's faces along up where it is not periodic;
/// - the lowest point of the surface: of bed_height and of the highest spheres in squares 2 diameters wide;
/// - the box about every other boundary: of the parts below and above it the higher is kept.
/// There is none where the container's place is not known, nothing is left, or a plane or boundary cuts the column from
/// top to bottom.
Interior interior_of(const Snapshot& snapshot, const Context& context, const Container& container);

}  // namespace packstone::analysis
