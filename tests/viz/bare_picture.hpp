// Options of a picture that shows only the particles.
#pragma once

#include "viz/particle_scene.hpp"

namespace packstone::testing {

inline viz::PictureOptions bare_picture(viz::View view, int width = 400, int height = 300) {
  viz::PictureOptions options;
  options.width = width;
  options.height = height;
  options.supersampling = 1;
  options.view = view;
  options.legend = options.time = options.container = options.scale = options.axes = false;
  return options;
}

}  // namespace packstone::testing
