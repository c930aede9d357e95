// The vector type that every part shares.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace packstone {

using Vec3 = Eigen::Vector3d;

/// Axis names by index, as scenes and messages write them.
inline constexpr const char* axis_names[3] = {"x", "y", "z"};

}  // namespace packstone
