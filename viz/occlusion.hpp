// Leaves out the particles that others hide, before they cost any drawing: a dense bed shows few of its particles.
#pragma once

#include <cstddef>
#include <vector>

#include "viz/camera.hpp"

namespace packstone::viz {

/// Rows of the spheres of which something may be seen in a picture of this size, ascending. Spheres that are not listed
/// change no pixel. Centres and radii are in the camera's space.
std::vector<std::size_t> visible_rows(const std::vector<Vec3>& centres, const std::vector<double>& radii,
                                      const Camera& camera, int width, int height);

}  // namespace packstone::viz
