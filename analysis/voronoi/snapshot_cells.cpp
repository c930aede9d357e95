#include "analysis/voronoi/snapshot_cells.hpp"

namespace packstone::analysis {

SnapshotCells snapshot_cells(const Snapshot& snapshot, const Context& context) {
  const std::size_t n = snapshot.size();
  std::vector<Vec3> centre;
  for (const Vec3& p : snapshot.position) centre.push_back(snapshot.domain.wrapped(p));
  std::optional<CellContainer> container;
  if (n > 0) container = cell_container(snapshot, centre);
  if (!container || !container->has_volume()) {
    return {
        std::nullopt,
        {std::vector<double>(n, 0.0), std::vector<std::uint16_t>(n, 0), std::vector<CellState>(n, CellState::outside)}};
  }
  const BedSurface surface(context.frame, *container, centre, snapshot.radius);
  return {container, radical_cells(centre, snapshot.radius, *container, surface)};
}

}  // namespace packstone::analysis
