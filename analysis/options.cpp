#include "analysis/options.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr double most_bond_cutoff = 3;
constexpr int most_bond_neighbours = 100;
constexpr int fewest_pore_points = 2;
constexpr double right_angle = 90;  // [degrees]

void require(bool good, const char* what, double value, const std::string& right) {
  if (!good) throw InputError(fmt::format("{} is {:g}; it must be {}", what, value, right));
}

/// Numbers for which 0 stands for the default.
void require_not_negative(const char* what, double value) {
  require(value >= 0 && std::isfinite(value), what, value, "above 0 (0: the default)");
}

}  // namespace

void check_options(const Options& o) {
  require_not_negative("the thickness of the profile's layers", o.profile_layer);
  require_not_negative("the thickness of the segregation's layers", o.segregation_layer);
  require_not_negative("the width of the rings and shells at walls", o.wall_layer);
  require_not_negative("the width of the map's cells", o.map_cell);
  require_not_negative("the radius of the surface's probe", o.surface_probe);
  require_not_negative("the step of the surface", o.surface_step);
  require(o.interior_margin >= 0 && std::isfinite(o.interior_margin), "the interior's margin", o.interior_margin,
          "0 or above");

  require_not_negative("the range of the radial distribution function", o.rdf_range);
  require_not_negative("the width of the radial distribution function's bins", o.rdf_bin);
  require(o.bond_cutoff >= 1 && o.bond_cutoff <= most_bond_cutoff, "the bonds' cut-off in sums of radii", o.bond_cutoff,
          fmt::format("from 1 to {:g}", most_bond_cutoff));
  require(o.bond_neighbours >= 0 && o.bond_neighbours <= most_bond_neighbours, "the number of bonded neighbours",
          o.bond_neighbours, fmt::format("1 to {} (0: by the cut-off)", most_bond_neighbours));
  require(o.pore_points >= fewest_pore_points, "the number of points for pores", o.pore_points,
          fmt::format("{} or more", fewest_pore_points));

  require_not_negative("the edge of the segregation's cells", o.segregation_cell);
  require(o.segregation_rings == 0 || o.segregation_rings >= 2, "the number of the segregation's rings",
          o.segregation_rings, "two or more (0: the default)");

  require_not_negative("the gap that joins clusters", o.clusters.gap);
  require_not_negative("the force that joins clusters", o.clusters.least_force);

  const ForceOptions& f = o.forces;
  require(f.chain_threshold >= 0 && std::isfinite(f.chain_threshold), "the chains' threshold", f.chain_threshold,
          "0 or above");
  require(f.chain_angle > 0 && f.chain_angle <= right_angle, "the chains' angle", f.chain_angle,
          "above 0 and at most 90 degrees");
  require_not_negative("the kernel's width", f.kernel_width);
  require_not_negative("the width of the coarse-grained fields' cells", f.coarse_cell);
  require(f.resolution > 0 && std::isfinite(f.resolution), "the communities' resolution", f.resolution, "above 0");
}

}  // namespace packstone::analysis
