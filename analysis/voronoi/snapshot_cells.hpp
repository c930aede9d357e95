// The radical Voronoi cells of a snapshot.
#pragma once

#include <optional>

#include "analysis/context.hpp"
#include "analysis/voronoi/radical_cells.hpp"

namespace packstone::analysis {

struct SnapshotCells {
  std::optional<CellContainer> container;  ///< none without particles, or where it holds no volume
  RadicalCells cells;                      ///< without a container every particle is outside
};

/// Throws InputError as radical_cells does.
SnapshotCells snapshot_cells(const Snapshot& snapshot, const Context& context);

}  // namespace packstone::analysis
