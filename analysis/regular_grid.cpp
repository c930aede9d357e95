#include "analysis/regular_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone::analysis {

double suitable_width(double wanted, double volume, double cells_wanted, double most_cells) {
  constexpr double fewest_cells = 4096;  // that few particles may have
  return std::max(wanted, std::cbrt(volume / std::clamp(cells_wanted, fewest_cells, most_cells)));
}

RegularGrid divided(const BoxRegion& box, double width, double most_cells, const char* name) {
  constexpr double slack = 1.1;  // of the width advised, over what would just do
  const Vec3 size = box.max - box.min;
  const Vec3 cells = (size / width).array().round().cwiseMax(1).matrix();
  if (!(cells.prod() <= most_cells)) {
    throw InputError(
        fmt::format("{} with cells of {:g} m has {:.3g} cells; at most {:.3g} are made: take cells of {:.3g} m or more",
                    name, width, cells.prod(), most_cells, slack * std::cbrt(size.prod() / most_cells)));
  }
  RegularGrid grid{.origin = box.min, .spacing = size.cwiseQuotient(cells)};
  for (int k = 0; k < 3; ++k) grid.count[k] = static_cast<std::size_t>(cells[k]);
  return grid;
}

}  // namespace packstone::analysis
