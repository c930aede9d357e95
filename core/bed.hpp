// Fraction and height of a bed: one definition for the engine's history and for the analysis.
#pragma once

#include <span>

namespace packstone {

/// The bulk of a bed lies between these shares of its height: away from the floor's layering and from the loose
/// surface.
inline constexpr double bulk_lower = 0.1;
inline constexpr double bulk_upper = 0.8;

struct BedState {
  double bulk_fraction = 0;  ///< solid volume over the volume of the bulk, in [0, 1) unless spheres overlap strongly
  double height = 0;         ///< of the equivalent uniform bed [m]
};

/// Solid volume of spheres between two heights, overlaps counted twice [m3].
double solid_volume_between(std::span<const double> height, std::span<const double> radius, double lower, double upper);

/// Fraction f and height h of a bed that agree with each other:
///   f = V(0.1 h, 0.8 h) / (0.7 h A),   h = V / (f A),
/// with V(a, b) the solid volume between two heights above the floor (exact sphere slabs) and V all of it. So h is the
/// height that the same solid would have at the bulk's fraction throughout, and the bulk holds 70 % of the solid. Of
/// several solutions one near twice the height of the centre of mass (exact for a uniform bed), else the nearest above,
/// else below (lone particles far above the bed).
///
/// height_above_floor: of the centres [m]; radius [m], as many rows; area of the bed's cross-section [m2].
/// Where no h satisfies both (particles strewn over many decades of height), h is twice the height of the centre of
/// mass and f = V / (h A). Without solid, without area or with all solid below the floor both are 0. Always finite.
/// O(N), about ten passes.
BedState measure_bed(std::span<const double> height_above_floor, std::span<const double> radius, double area);

}  // namespace packstone
