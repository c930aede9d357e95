// How finely forces between particles are resolved in single precision.
#pragma once

#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/filling/population.hpp"

namespace packstone::engine {

/// Rounding of an overlap in single precision, root mean square, as a share of the pair's mean radius
/// (tests/engine/test_precision.cpp).
inline constexpr double single_resolution = 7e-8;

/// By how much forces between particles are rounded in single precision, over the weight of a sphere: the worst of the
/// smallest spheres of each group on the largest of all, under the scene's gravity, which must be there.
double rounding_over_weight(const Scene& scene, const Population& population);

/// Warns where `precision = "mixed"` rounds a contact's force by more than a hundredth of the sphere's weight: a bed's
/// surface then jitters by that much. Counted for the smallest sphere of each group on the largest of all, under the
/// scene's gravity.
void warn_of_lost_weight(const Scene& scene, const Population& population, std::vector<std::string>& warnings);

}  // namespace packstone::engine
