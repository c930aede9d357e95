// Surfaces z = f(x, y), in triangles.
#pragma once

#include <string>

#include "core/scene.hpp"
#include "engine/boundary/flat_shape.hpp"

namespace packstone::engine {

/// A formula over the domain in as many equal cells as the tolerance asks for [m]; measured against the formula at the
/// middles of cells and of their sides. path: of the boundary in the scene, where faults are located.
TriangleSurface surface_of_formula(const Scene& scene, const std::string& path, const std::string& formula,
                                   double tolerance);

/// A file of points of a rectangular grid, joined. Throws InputError that names the file and its line.
TriangleSurface surface_of_grid(const std::string& file);

}  // namespace packstone::engine
