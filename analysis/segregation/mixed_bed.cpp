#include "analysis/segregation/mixed_bed.hpp"

#include <algorithm>
#include <utility>

#include "analysis/mean_diameter.hpp"

namespace packstone::analysis {

namespace {

constexpr double default_cell_diameters = 3;
constexpr double finest_cell_diameters = 1.5;

/// Empty when the types can be told apart; else why not.
std::string reason_against(const SpeciesList& list, const Amounts& amounts) {
  if (list.label.empty()) return "no particles";
  if (list.size() < 2) return "the packing has one type of particle only";
  if (std::all_of(amounts.by_species.begin(), amounts.by_species.end(), [](double a) { return a > 0; })) return "";
  return amounts.by == ShareBy::mass ? "a type has no mass" : "a type has no solid volume";
}

int chosen_axis(const Context& context) {
  const AlongAxis along = context.options.segregation_axis;
  return along == AlongAxis::up ? context.frame.axis : static_cast<int>(along) - static_cast<int>(AlongAxis::x);
}

/// Compartments that hold something.
std::size_t occupied(const Composition& composition) {
  return static_cast<std::size_t>(
      std::count_if(composition.whole.begin(), composition.whole.end(), [](double w) { return w > 0; }));
}

DividedBed divided(Division division, const MixedBed& bed, const std::string& reason_against_one) {
  DividedBed part{std::move(division)};
  part.composition = composition_of(part.division, bed.list.label, bed.amounts.of, bed.list.size());
  if (occupied(part.composition) < 2) part.missing = reason_against_one;
  return part;
}

void divide_into_layers(MixedBed& bed) {
  const Options& options = bed.context.options;
  const double wanted = options.segregation_layer > 0 ? options.segregation_layer : 2 * bed.context.mean_radius;
  bed.layers = layers_over_bed(bed.frame, bed.snapshot.radius, wanted);
  DividedBed& part = bed.parts[layers_part];
  if (bed.layers.count < 2) {
    part.missing = "the packing is one layer thick";
  } else {
    part = divided(divided_into_layers(bed.frame, bed.snapshot.radius, bed.layers), bed, "all solid lies in one layer");
  }
}

void divide_into_rings(MixedBed& bed, double diameter) {
  const auto wanted = static_cast<std::size_t>(bed.context.options.segregation_rings);
  bed.rings = rings_about(bed.snapshot, bed.frame.axis, wanted, diameter);
  DividedBed& part = bed.parts[rings_part];
  part.missing = bed.rings.missing;
  if (!part.missing.empty()) return;
  part = divided(divided_into_rings(bed.snapshot, bed.rings), bed, "all particles lie in one ring");
}

void divide_into_cells(MixedBed& bed, double diameter) {
  const double chosen = bed.context.options.segregation_cell;
  const double edge = chosen > 0 ? chosen : default_cell_diameters * diameter;
  DividedBed& part = bed.parts[cells_part];
  if (!(edge > 0)) {
    part.missing = "the particles have no size, and no cell is chosen";
    return;
  }
  const CellGrid grid = cell_grid(bed.snapshot, edge);
  part = divided(divided_into_cells(bed.snapshot, grid), bed, "all particles lie in one cell");
}

void divide_at_all_scales(MixedBed& bed, double diameter) {
  const auto grids = grids_of_all_scales(bed.snapshot, finest_cell_diameters * diameter);
  std::vector<Division> divisions(grids.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < grids.size(); ++k) divisions[k] = divided_into_cells(bed.snapshot, grids[k]);
  for (std::size_t k = 0; k < grids.size(); ++k) {
    if (divisions[k].count < 2) continue;
    bed.grids.push_back(grids[k]);
    bed.scales.push_back(std::move(divisions[k]));
  }
}

}  // namespace

double MixedBed::separated_variance() const {
  double sum = 0;
  for (std::size_t s = 0; s < list.size(); ++s) sum += amounts.share(s) * (1 - amounts.share(s));
  return sum;
}

double MixedBed::separated_distance() const {
  std::vector<double> shares;
  for (std::size_t s = 0; s < list.size(); ++s) shares.push_back(list.share(s));
  std::sort(shares.begin(), shares.end());
  return 1 - (shares[0] + shares[1]) / 2;
}

MixedBed mixed_bed(const Snapshot& snapshot, const Context& context) {
  SpeciesList list = species_of(snapshot);
  Amounts amounts = amounts_of(snapshot, list, context.options.segregation_by);
  MixedBed bed{snapshot, context, std::move(list), frame_along(snapshot, context.frame, chosen_axis(context)),
               std::move(amounts)};
  bed.missing = reason_against(bed.list, bed.amounts);
  if (!bed.missing.empty()) return bed;
  const auto& by_species = bed.amounts.by_species;
  bed.scarcest = static_cast<std::size_t>(std::min_element(by_species.begin(), by_species.end()) - by_species.begin());
  const double diameter = volume_mean_diameter(snapshot.radius);
  divide_into_layers(bed);
  divide_into_rings(bed, diameter);
  divide_into_cells(bed, diameter);
  divide_at_all_scales(bed, diameter);
  return bed;
}

}  // namespace packstone::analysis
