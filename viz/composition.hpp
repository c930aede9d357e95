// Bodies and walls laid together, and brought from samples down to pixels.
#pragma once

#include "viz/image.hpp"
#include "viz/pixel_layer.hpp"
#include "viz/pixel_window.hpp"
#include "viz/wall_layer.hpp"

namespace packstone::viz {

/// Every pixel is the mean of supersampling x supersampling samples, of each the nearer of body and wall. walls may
/// be null; else they are prepared for the layer's window. Takes the place of what was in the layer.
void compose(const PixelLayer& bodies, const WallLayer* walls, int supersampling, Layer& layer);

}  // namespace packstone::viz
