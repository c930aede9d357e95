// The free surface of a bed: what a ball that rolls over it from above cannot reach.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/packing/container.hpp"

namespace packstone::analysis {

/// More than that take gigabytes.
inline constexpr double most_surface_columns = 1.6e7;

/// Heights over a regular grid of columns in a bed's cross-section.
struct SurfaceHeights {
  double probe = 0;                       ///< radius of the ball [m]
  std::array<int, 2> across = {};         ///< the two axes of the cross-section
  std::array<double, 2> origin = {};      ///< middle of the first column [m]
  std::array<double, 2> step = {};        ///< between columns [m]
  std::array<std::size_t, 2> count = {};  ///< of columns
  std::vector<double> height = {};        ///< (count[1] * count[0]) above the floor [m]; NaN outside of a round bed

  std::size_t columns() const { return height.size(); }
};

/// Radius of the ball for a bed [m]: context.options.surface_probe, else the volume-mean radius.
double surface_probe(const Snapshot& snapshot, const Context& context);

/// Distance of the columns [m]: context.options.surface_step, else an eighth of the probe's radius or of the
/// volume-mean radius, whichever is less, wider where that makes more than most_surface_columns / 4.
double surface_step(const Snapshot& snapshot, const Context& context, const Container& container);

/// Over every point of the cross-section the lowest place that the ball's surface reaches while its centre stays in
/// the cross-section, above the floor by its radius or more, and so high above it that nothing of a sphere is in its
/// way:
///   c(y) = max over spheres of z + sqrt((r + p)^2 - |y - x|^2),  h(x) = min over |y - x| < p of c(y) - sqrt(p^2 - |y -
///   x|^2),
/// the closing by a ball, which of an alpha shape with the radii taken into account is the part that is seen from above
/// (Edelsbrunner and Muecke, ACM Trans. Graph. 13 (1994) 43; Stukowski, JOM 66 (2014) 399). c is exact on the columns;
/// h is never too low, and too high by less than the step times the slope of c at the ball's place of rest.
/// The same bits for any number of threads. O(N + columns (probe / step)^2).
/// No columns where the container's place is not known, the domain is periodic along up, or the cross-section is empty.
/// Throws InputError for more than most_surface_columns.
SurfaceHeights free_surface(const Snapshot& snapshot, const Context& context, const Container& container, double step);

}  // namespace packstone::analysis
