#include "analysis/segregation/tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "analysis/segregation/centres.hpp"
#include "analysis/segregation/indices.hpp"

namespace packstone::analysis {

namespace {

/// Lower and upper edge of a compartment [m].
using Edges = std::function<std::pair<double, double>(std::size_t)>;

void put_compositions(Table& table, const MixedBed& bed, Part part, const Edges& edges) {
  table.caption = "Share by " + bed.amounts.noun() + " of each type (" + bed.list.legend() + ") in " +
                  compartments_text(bed, part) +
                  "; expected: its share of the whole bed; spread: standard deviation for random mixing; z: (share - "
                  "expected) / spread";
  const DividedBed& divided = bed.parts[part];
  const Composition& c = divided.composition;
  const auto variances = random_variance(divided.division, bed.list, bed.amounts, c);
  for (std::size_t l = 0; l < divided.division.count; ++l) {
    const auto [lower, upper] = edges(l);
    const bool empty = !(c.whole[l] > 0);
    for (std::size_t s = 0; s < bed.list.size(); ++s) {
      const double spread = std::sqrt(std::max(0.0, variances[l * bed.list.size() + s]));
      const double share = empty ? no_value : c.share(l, s), expected = c.mean[s];
      table.rows.push_back({lower, upper, static_cast<double>(bed.list.species[s].type), share, expected,
                            empty ? no_value : spread, spread > 0 ? (share - expected) / spread : no_value});
    }
  }
}

std::vector<Column> composition_columns(const char* lower, const char* upper) {
  return {{lower, "m"}, {upper, "m"}, {"type", "", ColumnFormat::integer}, {"share"}, {"expected"}, {"spread"}, {"z"}};
}

double lacey_of(const LaceyScale& scale, double variance) { return scale.exists() ? scale(variance) : no_value; }

}  // namespace

Table layer_table(const MixedBed& bed) {
  Table table{.key = "composition", .columns = composition_columns("lower", "upper")};
  put_compositions(table, bed, layers_part,
                   [&](std::size_t l) { return std::pair(bed.layers.lower(l), bed.layers.upper(l)); });
  return table;
}

Table ring_table(const MixedBed& bed) {
  Table table{.key = "rings", .columns = composition_columns("inner", "outer")};
  put_compositions(table, bed, rings_part,
                   [&](std::size_t r) { return std::pair(bed.rings.inner(r), bed.rings.outer(r)); });
  return table;
}

Table type_table(const MixedBed& bed) {
  Table table{.key = "types",
              .caption = "Types (" + bed.list.legend() + "): share by " + bed.amounts.noun() +
                         ", height of the centre above the floor, and of the type alone over the layers: intensity of "
                         "segregation s^2 / s0^2 and relative standard deviation s / P, beside that of a separated bed",
              .columns = {{"type", "", ColumnFormat::integer},
                          {"particles", "", ColumnFormat::integer},
                          {"share"},
                          {"centre_height", "m"},
                          {"intensity"},
                          {"rsd"},
                          {"rsd_separated"}}};
  const BedFrame& up = bed.context.frame;
  const auto centres = centres_of(bed.snapshot.position, bed.list.label, bed.amounts.of, bed.list.size());
  const DividedBed& layers = bed.parts[layers_part];
  const bool layered = layers.missing.empty();
  const auto variances =
      layered ? variance_by_species(layers.composition) : std::vector<double>(bed.list.size(), no_value);
  for (std::size_t s = 0; s < bed.list.size(); ++s) {
    const double p = bed.amounts.share(s);
    table.rows.push_back({static_cast<double>(bed.list.species[s].type), static_cast<double>(bed.list.species[s].count),
                          p, up.sign * (centres[s][up.axis] - up.floor), variances[s] / (p * (1 - p)),
                          std::sqrt(variances[s]) / p, std::sqrt((1 - p) / p)});
  }
  return table;
}

Table scale_table(const MixedBed& bed, const MixingNumbers& numbers) {
  Table table{.key = "scale",
              .caption = "Scale of scrutiny: the indices of cells (cell_lacey, cell_intensity, cell_rsd of " +
                         bed.list.species[bed.scarcest].name +
                         ", cell_entropy) over the cells' edge (cube root of their volume), from 1.5 diameters sum "
                         "d^4 / sum d^3 to the longest side of the bed's box. particles: mean of the cells that hold "
                         "any; random, deviation: mean and standard deviation in " +
                         numbers.model + "; separated: the types one on another along that side, in the same cells",
              .columns = {{"edge", "m"}, {"cells", "", ColumnFormat::integer}, {"particles"}}};
  for (const char* index : {"lacey", "intensity", "rsd", "entropy"}) {
    for (const char* what : {"", "_random", "_deviation", "_separated"}) {
      table.columns.push_back({std::string(index) + what});
    }
  }
  std::vector<LaceyScale> lacey_scales(bed.scales.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < bed.scales.size(); ++k) {
    lacey_scales[k] = lacey_scale(bed, bed.scales[k], numbers.random[index_of_scale(k, variance)]);
  }
  const double particles = static_cast<double>(bed.snapshot.size());
  for (std::size_t k = 0; k < bed.scales.size(); ++k) {
    const double cells = static_cast<double>(bed.scales[k].count);
    std::vector<double> row = {bed.grids[k].edge(), cells, particles / cells};
    const std::size_t s2 = index_of_scale(k, variance);
    const RandomReference& random = numbers.random[s2];
    const LaceyScale& scale = lacey_scales[k];
    row.insert(row.end(), {lacey_of(scale, numbers.found[s2]), lacey_of(scale, random.mean),
                           scale.exists() ? random.deviation / scale.contrast() : no_value,
                           lacey_of(scale, numbers.separated[s2])});
    row.insert(row.end(), {numbers.found[s2] / scale.separated, random.mean / scale.separated,
                           random.deviation / scale.separated, numbers.separated[s2] / scale.separated});
    for (const DivisionNumber number : {relative_deviation, entropy}) {
      const std::size_t at = index_of_scale(k, number);
      row.insert(row.end(),
                 {numbers.found[at], numbers.random[at].mean, numbers.random[at].deviation, numbers.separated[at]});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace packstone::analysis
