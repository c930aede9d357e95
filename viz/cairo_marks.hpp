// A drawing through Cairo, which fills exact shapes: circles and letters stay what they are.
#pragma once

#include "viz/drawing.hpp"

typedef struct _cairo cairo_t;

namespace packstone::viz {

/// Draws all marks. One unit of the context is one pixel of the drawing.
void draw_marks(cairo_t* context, const Drawing& drawing);

}  // namespace packstone::viz
