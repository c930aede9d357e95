// What the measures share about one snapshot, worked out once.
#pragma once

#include "analysis/contact_network.hpp"
#include "analysis/options.hpp"
#include "core/bed.hpp"
#include "core/bed_frame.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

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
