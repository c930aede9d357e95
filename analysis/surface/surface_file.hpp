// The free surface as a file of VTK.
#pragma once

#include <filesystem>

#include "analysis/options.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// Writes the free surface (rolling_ball.hpp) as VTK XML PolyData: a point over the middle of every column, two
/// triangles between each four, normals up; point data "height" above the floor [m] (float64). Throws InputError where
/// the name does not end in .vtp or the bed has no free surface, RunError when the disk refuses.
void write_surface(const std::filesystem::path& path, const Snapshot& snapshot, const Options& options);

}  // namespace packstone::analysis
