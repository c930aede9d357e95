// The discs in which a plane cuts the spheres of a packing.
#pragma once

#include <cstddef>
#include <vector>

#include "core/particle_view.hpp"
#include "viz/slice_plane.hpp"

namespace packstone::viz {

/// Where the plane cuts one sphere.
struct Disc {
  double u = 0;         ///< centre, as SlicePlane::place [m]
  double v = 0;         ///< [m]
  double radius = 0;    ///< sqrt(r^2 - h^2), h being the sphere's distance from the plane [m]
  std::size_t row = 0;  ///< of the particle in the snapshot
};

/// Throws InputError when the plane misses the domain.
void check_plane(const Domain& domain, const SlicePlane& plane);

/// All discs that reach into the domain, the periodic images included, so that the parts inside the domain add up to
/// the area cut; across an axis exactly one image of each disc has its centre in the domain along the periodic axes.
/// Of chunks of rows that the plane misses none is looked at. Throws InputError when the plane misses the domain, and
/// as check_rows does.
std::vector<Disc> slice_discs(const ParticleView& particles, const SlicePlane& plane);

}  // namespace packstone::viz
