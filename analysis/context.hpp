// What the measures share about one snapshot, worked out once.
#pragma once

#include "analysis/contact_network.hpp"
#include "core/bed.hpp"
#include "core/bed_frame.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// What the user may choose.
struct Options {
  double profile_layer = 0;      ///< thickness of the layers of the vertical profile [m]; 0: one mean radius
  double segregation_layer = 0;  ///< thickness of the layers of the segregation index [m]; 0: one mean diameter
  bool voronoi_cells = false;    ///< measure voronoi also lists every cell
};

struct Context {
  Options options;
  BedFrame frame;
  ContactNetwork contacts;
  BedState bed = {};       ///< zero where the domain is periodic along up, or nothing lies above the floor
  double mean_radius = 0;  ///< number mean [m]; 0 without particles
};

/// Checks the snapshot first: rows of all arrays agree, positions and radii are numbers, types refer to groups.
/// Throws InputError otherwise.
Context make_context(const Snapshot& snapshot, const Options& options = {});

}  // namespace packstone::analysis
