// What counts as rest.
#pragma once

namespace packstone::analysis {

/// A bed whose kinetic energy is below this share of the sum of m g d is at rest.
inline constexpr double rest_threshold = 5e-5;

}  // namespace packstone::analysis
