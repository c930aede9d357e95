// Where the centre of each type lies, and how far apart the centres are.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.hpp"

namespace packstone::analysis {

/// (species) mean position of a type's particles, weighted by their amounts [m]; all zero for one without amount.
std::vector<Vec3> centres_of(std::span<const Vec3> position, std::span<const std::int32_t> label,
                             std::span<const double> amount, std::size_t species);

/// Largest difference of two centres' coordinates along the axis [m].
double extent_along(const std::vector<Vec3>& centres, int axis);

/// Largest distance of two centres, over the axes that are not periodic [m].
double farthest_apart(const std::vector<Vec3>& centres, const std::array<bool, 3>& periodic);

/// Variance of the particles' coordinates along the axis, weighted by amount, for a population of N [m2]. 0 for N < 2.
double coordinate_variance(std::span<const Vec3> position, std::span<const double> amount, int axis);

}  // namespace packstone::analysis
