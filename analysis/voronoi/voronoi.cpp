// Measure "voronoi": how densely the packing lies around each particle.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "analysis/measures.hpp"
#include "analysis/voronoi/snapshot_cells.hpp"
#include "analysis/voronoi/whole_cells.hpp"
#include "core/text.hpp"

namespace packstone::analysis {

namespace {

/// Cells that sum up to the container's volume within this share fill it.
constexpr double face_rounding = 1e-9;

/// Smallest possible cell of a sphere among equal ones, over its diameter cubed: the regular dodecahedron around it
/// (Hales & McLaughlin, J. Am. Math. Soc. 23 (2010) 299).
constexpr double smallest_cell = 0.693786;

/// Radii that differ by less than this share count as equal.
constexpr double equal_radii = 1e-6;

struct Tally {
  double cells = 0, surface = 0, empty = 0, outside = 0;
};

Tally counted(const RadicalCells& cells) {
  Tally tally;
  for (const CellState state : cells.state) {
    tally.surface += state == CellState::surface;
    tally.empty += state == CellState::empty;
    tally.outside += state == CellState::outside;
  }
  tally.cells = static_cast<double>(cells.state.size()) - tally.empty - tally.outside;
  return tally;
}

std::string left_out_note(const CellContainer& container) {
  return container.left_out.empty() ? "" : "cells are not cut by " + joined(container.left_out);
}

void add_counts(MeasureResult& result, const Tally& tally) {
  result.quantities.push_back(
      {.key = "cells",
       .label = "Voronoi cells",
       .value = tally.cells,
       .definition = "particles whose radical Voronoi cell is not empty: all x with |x - x_i|^2 - R_i^2 smallest "
                     "(Gellatly & Finney, J. Non-Cryst. Solids 50 (1982) 313), by voro++ (Rycroft, Chaos 19 (2009) "
                     "041111)"});
  result.quantities.push_back(
      {.key = "surface_cells",
       .label = "cells at the surface",
       .value = tally.surface,
       .definition =
           "cells with a corner more than one mean radius above the tops of all spheres in its column (two "
           "largest diameters wide, twice the mean distance between particles at least); they hold open space "
           "and are left out of all statistics. None where the container repeats along up"});
  result.quantities.push_back(
      {.key = "lost_cells",
       .label = "particles without cell",
       .value = tally.empty,
       .definition = "particles inside the container without a cell: covered by larger spheres' cells, at the place of "
                     "another particle (nearer than 1e-6 of the mean distance), or lost by voro++, which volume_error "
                     "then shows"});
  result.quantities.push_back(
      {.key = "outside_particles",
       .label = "particles outside the container",
       .value = tally.outside,
       .definition = "particles whose centre lies outside the container (see container_volume); they take no part"});
}

void add_volumes(MeasureResult& result, const CellContainer* container, const RadicalCells& cells, const Tally& tally,
                 const std::string& reason) {
  Quantity volume{
      .key = "container_volume",
      .label = "volume of the container",
      .unit = "m3",
      .definition =
          "of the domain, cut by the boundaries that hold 99 % of the centres: planes, one-sided convex boundaries of "
          "flat faces and cylinders (prisms of equal cross-section, within 0.1 % of a mean radius), extended without "
          "end; open sides end two largest diameters and a tenth of the packing's extent beyond the outermost centres"};
  Quantity error{.key = "volume_error",
                 .label = "volume error",
                 .definition = "(sum of the volumes of all cells - container_volume) / container_volume"};
  if (container == nullptr) {
    result.quantities.push_back(not_applicable(volume, reason));
    result.quantities.push_back(not_applicable(error, reason));
    return;
  }
  volume.value = cells.container_volume;
  volume.note = left_out_note(*container);
  result.quantities.push_back(volume);
  if (tally.cells == 0) {
    result.quantities.push_back(not_applicable(error, reason));
    return;
  }
  double sum = 0;
  for (double v : cells.volume) sum += v;
  error.value = (sum - cells.container_volume) / cells.container_volume;
  if (std::abs(*error.value) > face_rounding) {
    error.note = fmt::format(
        "the cells do not fill the container: voro++ lost or miscut some ({:.0f} particles have no "
        "cell)",
        tally.empty);
  }
  result.quantities.push_back(error);
}

void set_spread(Quantity& mean, Quantity& deviation, std::span<const double> values) {
  const Spread spread = spread_of(values);
  mean.value = spread.mean;
  if (values.size() < 2) {
    deviation = not_applicable(deviation, "only one cell within the packing");
    return;
  }
  mean.uncertainty = spread.deviation / std::sqrt(static_cast<double>(values.size()));
  deviation.value = spread.deviation;
}

void add_fractions(MeasureResult& result, const WholeCells& cells, const std::string& reason, const std::string& note) {
  Quantity mean{.key = "local_fraction_mean",
                .label = "local solid fraction, mean",
                .definition =
                    "mean of (volume of the sphere) / (volume of its radical Voronoi cell) over the cells that "
                    "are not at the surface; a sphere counts whole, even where it overlaps others; "
                    "uncertainty: standard deviation over sqrt(N), as if cells were independent",
                .note = note};
  Quantity deviation{.key = "local_fraction_deviation",
                     .label = "local solid fraction, deviation",
                     .definition = "sample standard deviation of the same"};
  Quantity by_volume{.key = "local_fraction_mean_by_volume",
                     .label = "local solid fraction, mean by volume",
                     .definition =
                         "the same, every cell weighted with its volume: the spheres' volume over the cells' "
                         "volume together, so the solid fraction of the region they fill"};
  Quantity by_volume_deviation{.key = "local_fraction_deviation_by_volume",
                               .label = "local solid fraction, deviation by volume",
                               .definition =
                                   "standard deviation of the local solid fraction, every cell weighted with "
                                   "its volume: sqrt(sum V (f - mean)^2 / sum V)"};
  if (!reason.empty()) {
    for (Quantity* q : {&mean, &deviation, &by_volume, &by_volume_deviation}) *q = not_applicable(*q, reason);
  } else {
    set_spread(mean, deviation, cells.fraction);
    const Spread weighted = weighted_spread(cells.fraction, cells.volume);
    by_volume.value = weighted.mean;
    by_volume_deviation.value = weighted.deviation;
  }
  for (const Quantity& q : {mean, deviation, by_volume, by_volume_deviation}) result.quantities.push_back(q);
}

/// Shape of the distribution of cell volumes; "" or why it has none.
std::string set_gamma_shape(Quantity& shape, const WholeCells& cells) {
  const auto [smallest, largest] = std::minmax_element(cells.solid.begin(), cells.solid.end());
  if (!(*largest > 0)) return "all radii are 0";
  if (*largest > *smallest * (1 + 3 * equal_radii)) return "the radii differ";
  const Spread volume = spread_of(cells.volume);
  if (!(volume.deviation > face_rounding * volume.mean)) return "the cells do not differ";
  const double diameter_cubed = *largest * 6 / std::numbers::pi;
  const double free_volume = volume.mean - smallest_cell * diameter_cubed;
  if (!(free_volume > 0)) return "the cells are smaller than those of spheres without overlap";
  shape.value = free_volume * free_volume / (volume.deviation * volume.deviation);
  return "";
}

void add_reduced_volumes(MeasureResult& result, const WholeCells& cells, const std::string& reason) {
  Quantity mean{.key = "reduced_volume_mean",
                .label = "reduced cell volume, mean",
                .definition =
                    "mean of (volume of the cell) / (volume of its sphere), the inverse of the local solid "
                    "fraction, over the same cells; uncertainty as for local_fraction_mean"};
  Quantity deviation{.key = "reduced_volume_deviation",
                     .label = "reduced cell volume, deviation",
                     .definition = "sample standard deviation of the same"};
  Quantity shape{.key = "gamma_shape",
                 .label = "shape of the cell volumes' gamma distribution",
                 .definition =
                     "k = (<V> - V_min)^2 / variance of V, of the cells of equal spheres; V_min = 0.694 d^3, the "
                     "regular dodecahedron (Aste et al., EPL 79 (2007) 24003)"};
  if (!reason.empty()) {
    for (Quantity* q : {&mean, &deviation, &shape}) *q = not_applicable(*q, reason);
  } else {
    if (*std::min_element(cells.solid.begin(), cells.solid.end()) > 0) {
      std::vector<double> reduced;
      for (double f : cells.fraction) reduced.push_back(1 / f);
      set_spread(mean, deviation, reduced);
    } else {
      for (Quantity* q : {&mean, &deviation}) *q = not_applicable(*q, "some radii are 0");
    }
    if (const std::string why = set_gamma_shape(shape, cells); !why.empty()) shape = not_applicable(shape, why);
  }
  for (const Quantity& q : {mean, deviation, shape}) result.quantities.push_back(q);
}

void add_faces(MeasureResult& result, const WholeCells& cells, const std::string& reason) {
  Quantity mean{.key = "faces_mean",
                .label = "faces of a cell, mean",
                .definition =
                    "mean number of faces, with other particles' cells and with the container, over the same "
                    "cells; uncertainty as for local_fraction_mean"};
  Quantity deviation{.key = "faces_deviation",
                     .label = "faces of a cell, deviation",
                     .definition = "sample standard deviation of the same"};
  if (!reason.empty()) {
    for (Quantity* q : {&mean, &deviation}) *q = not_applicable(*q, reason);
  } else {
    set_spread(mean, deviation, cells.faces);
  }
  result.quantities.push_back(mean);
  result.quantities.push_back(deviation);
}

std::string reason_against(const Snapshot& snapshot, const CellContainer* container, const Tally& tally,
                           const WholeCells& whole) {
  if (snapshot.size() == 0) return "no particles";
  if (container == nullptr || tally.cells == 0) return "the container holds no particle";
  return whole.size() == 0 ? "every cell is at the surface" : "";
}

}  // namespace

MeasureResult measure_voronoi(const Snapshot& snapshot, const Context& context) {
  const auto [container, cells] = snapshot_cells(snapshot, context);
  const CellContainer* used = container ? &*container : nullptr;
  const WholeCells whole = whole_cells(cells, snapshot.radius);
  const Tally tally = counted(cells);
  const std::string reason = reason_against(snapshot, used, tally, whole);

  MeasureResult result{.name = "voronoi"};
  add_fractions(result, whole, reason, used ? left_out_note(*used) : "");
  add_reduced_volumes(result, whole, reason);
  add_faces(result, whole, reason);
  add_counts(result, tally);
  add_volumes(result, used, cells, tally, reason);
  result.tables = {fraction_table(whole), faces_table(whole), type_table(whole, species_of(snapshot))};
  if (context.options.voronoi_cells) result.tables.push_back(cell_table(snapshot, cells));
  return result;
}

}  // namespace packstone::analysis
