// What the colours mean, drawn into a column.
#pragma once

#include "viz/colouring.hpp"
#include "viz/drawing.hpp"

namespace packstone::viz {

/// Width that draw_legend needs [px].
double legend_width(const ColourKey& key, double font);

/// Draws from the column's top left: swatches for categories, a colour bar of at most the column's height for a scale.
/// Returns the y at which it ends.
double draw_legend(Drawing& drawing, const Box& column, const ColourKey& key, double font);

/// A bar of a round length, at most room pixels long, with its length above. Its lower end is at the point.
void draw_scale_bar(Drawing& drawing, Point lower_left, double metres_per_pixel, double room, double font);

}  // namespace packstone::viz
