// Spheres as pixels: every pixel's ray met with every sphere that can be seen on it.
#pragma once

#include "viz/pixel_layer.hpp"
#include "viz/sphere_cloud.hpp"

namespace packstone::viz {

/// Draws spheres over what is there; the order of draws does not matter. With cull those that others hide cost little;
/// the pixels are the same.
void draw(PixelLayer& layer, const SphereCloud& cloud, bool cull = true);

}  // namespace packstone::viz
