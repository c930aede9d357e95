// The cells that the statistics of measure "voronoi" are taken over, and their tables.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/result.hpp"
#include "analysis/species.hpp"
#include "analysis/voronoi/radical_cells.hpp"

namespace packstone::analysis {

/// Cells within the packing: CellState::whole.
struct WholeCells {
  std::vector<std::uint32_t> row;  ///< of each cell's particle
  std::vector<double> solid;       ///< volume of each cell's sphere [m3]
  std::vector<double> volume;      ///< [m3]
  std::vector<double> fraction;    ///< solid / volume
  std::vector<double> faces;

  std::size_t size() const { return row.size(); }
};

/// Volume of a particle's sphere over that of its cell; no_value where it has no cell.
double local_fraction(const RadicalCells& cells, std::span<const double> radius, std::size_t row);

WholeCells whole_cells(const RadicalCells& cells, std::span<const double> radius);

/// Mean and standard deviation: sample deviation (N - 1) of equal weights, 0 for one value.
struct Spread {
  double mean = 0;
  double deviation = 0;
};

/// Of one value or more.
Spread spread_of(std::span<const double> values);

/// Weights above 0; deviation = sqrt(sum w (x - mean)^2 / sum w).
Spread weighted_spread(std::span<const double> values, std::span<const double> weights);

/// "local_fraction_distribution": in steps of 0.01, what is 1 or above in one last row.
Table fraction_table(const WholeCells& cells);

/// "faces_distribution": cells by their number of faces.
Table faces_table(const WholeCells& cells);

/// "types": means of every type that occurs.
Table type_table(const WholeCells& cells, const SpeciesList& species);

/// "cells": every particle, whatever its cell.
Table cell_table(const Snapshot& snapshot, const RadicalCells& cells);

}  // namespace packstone::analysis
