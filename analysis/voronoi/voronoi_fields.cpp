// The Voronoi cell of every particle.
#include "analysis/measures.hpp"
#include "analysis/voronoi/snapshot_cells.hpp"
#include "analysis/voronoi/whole_cells.hpp"

namespace packstone::analysis {

std::vector<ParticleField> voronoi_fields(const Snapshot& snapshot, const Context& context) {
  const RadicalCells cells = snapshot_cells(snapshot, context).cells;
  ParticleField fraction{
      .name = "local_fraction",
      .definition =
          "volume of the sphere over that of its radical Voronoi cell, as for local_fraction_mean; a "
          "cell at the surface (voronoi_state) holds open space; none without cell"};
  ParticleField volume{.name = "voronoi_volume", .unit = "m3", .definition = "of the cell; 0 without cell"};
  ParticleField faces{.name = "voronoi_faces", .definition = "of the cell; 0 without cell"};
  ParticleField state{.name = "voronoi_state",
                      .definition =
                          "0: cell within the packing, 1: at the surface, 2: empty, 3: the particle lies outside the "
                          "container"};
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    fraction.values.push_back(local_fraction(cells, snapshot.radius, i));
    state.values.push_back(static_cast<double>(cells.state[i]));
  }
  volume.values = cells.volume;
  faces.values = as_values(cells.faces);
  return {fraction, volume, faces, state};
}

}  // namespace packstone::analysis
