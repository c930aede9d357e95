// Fields on a regular grid as files of VTK.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "analysis/regular_grid.hpp"

namespace packstone::analysis {

/// A field with values for every cell.
struct CellArray {
  std::string name;
  std::vector<std::string> components = {};          ///< names of several; none: a scalar
  std::function<void(std::size_t, double*)> values;  ///< writes those of a cell; called cell by cell in their order
};

/// Throws InputError where the name does not end in .vti. what: of the file, "a map".
void require_image_extension(const std::filesystem::path& path, const char* what);

/// Writes VTK XML ImageData with the arrays as float64 cell data, appended raw; the first one is what viewers show. The
/// file is whole or absent. Throws RunError when the disk refuses.
/// Source: VTK file formats, "Serial XML file formats".
void write_image_data(const std::filesystem::path& path, const RegularGrid& grid, const std::vector<CellArray>& arrays);

}  // namespace packstone::analysis
