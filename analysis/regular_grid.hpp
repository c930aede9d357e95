// Cells of equal size that fill a box.
#pragma once

#include <array>
#include <cstddef>

#include "analysis/packing/region.hpp"

namespace packstone::analysis {

/// x fastest, then y, then z.
struct RegularGrid {
  Vec3 origin = Vec3::Zero();             ///< lower corner of the first cell [m]
  Vec3 spacing = Vec3::Ones();            ///< sides of a cell [m]
  std::array<std::size_t, 3> count = {};  ///< cells along x, y, z

  std::size_t cells() const { return count[0] * count[1] * count[2]; }
  double cell_volume() const { return spacing.prod(); }  ///< [m3]
  BoxRegion cell(std::size_t x, std::size_t y, std::size_t z) const {
    const Vec3 low =
        origin + spacing.cwiseProduct(Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)));
    return {low, low + spacing};
  }
};

/// Width of cells that suits a box of this volume [m3]: the one wanted [m], wider where that makes more cells than
/// wanted (but 4096 there may be) or than most_cells (above 4096).
double suitable_width(double wanted, double volume, double cells_wanted, double most_cells);

/// The grid that divides a box evenly into cells about so wide [m]. Throws InputError that calls it by its name ("a
/// map") for more than so many cells.
RegularGrid divided(const BoxRegion& box, double width, double most_cells, const char* name);

}  // namespace packstone::analysis
