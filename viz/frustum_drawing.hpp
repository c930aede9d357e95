// Tubes and cones as pixels: every pixel's ray met with every frustum that can be seen on it.
#pragma once

#include "viz/frustum_cloud.hpp"
#include "viz/pixel_layer.hpp"

namespace packstone::viz {

/// As draw() of sphere_drawing.hpp.
void draw(PixelLayer& layer, const FrustumCloud& cloud, bool cull = true);

}  // namespace packstone::viz
