#include "analysis/voronoi/whole_cells.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

constexpr std::size_t fraction_steps = 100;  // from 0 to 1

/// Sums of one type, or of all.
struct Sums {
  std::size_t cells = 0;
  double solid = 0, volume = 0, faces = 0;
};

}  // namespace

double local_fraction(const RadicalCells& cells, std::span<const double> radius, std::size_t row) {
  return cells.volume[row] > 0 ? sphere_volume(radius[row]) / cells.volume[row] : no_value;
}

WholeCells whole_cells(const RadicalCells& cells, std::span<const double> radius) {
  WholeCells whole;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    if (cells.state[i] != CellState::whole) continue;
    whole.row.push_back(static_cast<std::uint32_t>(i));
    whole.solid.push_back(sphere_volume(radius[i]));
    whole.volume.push_back(cells.volume[i]);
    whole.fraction.push_back(local_fraction(cells, radius, i));
    whole.faces.push_back(cells.faces[i]);
  }
  return whole;
}

Spread spread_of(std::span<const double> values) {
  const double n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (double x : values) sum += x;
  const double mean = sum / n;
  for (double x : values) squares += (x - mean) * (x - mean);
  return {mean, values.size() > 1 ? std::sqrt(squares / (n - 1)) : 0};
}

Spread weighted_spread(std::span<const double> values, std::span<const double> weights) {
  double weight = 0, sum = 0, squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    weight += weights[i];
    sum += weights[i] * values[i];
  }
  const double mean = sum / weight;
  for (std::size_t i = 0; i < values.size(); ++i) squares += weights[i] * (values[i] - mean) * (values[i] - mean);
  return {mean, std::sqrt(squares / weight)};
}

Table fraction_table(const WholeCells& cells) {
  Table table{.key = "local_fraction_distribution",
              .caption =
                  "Cells within the packing by local solid fraction, in steps of 0.01; all of 1 and above in the "
                  "last row. Density: share of the cells over the step's width",
              .columns = {{"lower"}, {"upper"}, {"cells", "", ColumnFormat::integer}, {"density"}, {"volume_share"}}};
  if (cells.size() == 0) return table;
  const double largest = *std::max_element(cells.fraction.begin(), cells.fraction.end());
  std::vector<std::size_t> count(fraction_steps + 1, 0);
  std::vector<double> volume(fraction_steps + 1, 0.0);
  double all = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double step = std::min(std::floor(cells.fraction[i] * fraction_steps), static_cast<double>(fraction_steps));
    ++count[static_cast<std::size_t>(step)];
    volume[static_cast<std::size_t>(step)] += cells.volume[i];
    all += cells.volume[i];
  }
  const auto bound = [](std::size_t step) { return static_cast<double>(step) / fraction_steps; };
  std::size_t first = 0, last = fraction_steps;
  while (count[first] == 0) ++first;
  while (count[last] == 0) --last;
  for (std::size_t step = first; step <= last; ++step) {
    const double upper = step == fraction_steps ? std::max(largest, bound(step + 1)) : bound(step + 1);
    const double share = static_cast<double>(count[step]) / static_cast<double>(cells.size());
    table.rows.push_back(
        {bound(step), upper, static_cast<double>(count[step]), share / (upper - bound(step)), volume[step] / all});
  }
  return table;
}

Table faces_table(const WholeCells& cells) {
  Table table{.key = "faces_distribution",
              .caption = "Cells within the packing by their number of faces",
              .columns = {{"faces", "", ColumnFormat::integer}, {"cells", "", ColumnFormat::integer}, {"share"}}};
  if (cells.size() == 0) return table;
  const auto [fewest, most] = std::minmax_element(cells.faces.begin(), cells.faces.end());
  std::vector<std::size_t> count(static_cast<std::size_t>(*most - *fewest) + 1, 0);
  for (double f : cells.faces) ++count[static_cast<std::size_t>(f - *fewest)];
  for (std::size_t k = 0; k < count.size(); ++k) {
    const double c = static_cast<double>(count[k]);
    table.rows.push_back({*fewest + static_cast<double>(k), c, c / static_cast<double>(cells.size())});
  }
  return table;
}

Table type_table(const WholeCells& cells, const SpeciesList& species) {
  Table table{.key = "types",
              .caption = "Cells within the packing by type (" + species.legend() +
                         "): mean and standard deviation of the local solid fraction, solid over volume of the type's "
                         "cells together, mean volume and mean number of faces of a cell",
              .columns = {{"type", "", ColumnFormat::integer},
                          {"cells", "", ColumnFormat::integer},
                          {"local_fraction_mean"},
                          {"local_fraction_deviation"},
                          {"fraction_by_volume"},
                          {"volume_mean", "m3"},
                          {"faces_mean"}}};
  std::vector<std::vector<double>> fraction(species.size());
  std::vector<Sums> sums(species.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto s = static_cast<std::size_t>(species.label[cells.row[i]]);
    fraction[s].push_back(cells.fraction[i]);
    ++sums[s].cells;
    sums[s].solid += cells.solid[i];
    sums[s].volume += cells.volume[i];
    sums[s].faces += cells.faces[i];
  }
  for (std::size_t s = 0; s < species.size(); ++s) {
    const double n = static_cast<double>(sums[s].cells), type = species.species[s].type;
    if (sums[s].cells == 0) {
      table.rows.push_back({type, 0, no_value, no_value, no_value, no_value, no_value});
      continue;
    }
    const Spread spread = spread_of(fraction[s]);
    table.rows.push_back({type, n, spread.mean, sums[s].cells > 1 ? spread.deviation : no_value,
                          sums[s].solid / sums[s].volume, sums[s].volume / n, sums[s].faces / n});
  }
  return table;
}

Table cell_table(const Snapshot& snapshot, const RadicalCells& cells) {
  Table table{
      .key = "cells",
      .caption =
          "The cell of every particle, by id; state 0: within the packing, 1: at the surface, 2: empty (covered "
          "by larger spheres' cells, or lost), 3: the particle lies outside the container",
      .columns = {{"id", "", ColumnFormat::integer},
                  {"type", "", ColumnFormat::integer},
                  {"volume", "m3"},
                  {"local_fraction"},
                  {"faces", "", ColumnFormat::integer},
                  {"state", "", ColumnFormat::integer}}};
  for (const std::size_t i : id_order(snapshot)) {
    table.rows.push_back({static_cast<double>(snapshot.id[i]), static_cast<double>(snapshot.type[i]), cells.volume[i],
                          local_fraction(cells, snapshot.radius, i), static_cast<double>(cells.faces[i]),
                          static_cast<double>(cells.state[i])});
  }
  return table;
}

}  // namespace packstone::analysis
