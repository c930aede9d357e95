// What the measures share about one snapshot, worked out once.
#pragma once

#include "analysis/contact_network.hpp"
#include "core/bed.hpp"
#include "core/bed_frame.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// What the shares of the types are of.
enum class ShareBy { number, volume, mass };

/// Up as the snapshot has it, or an axis of the domain.
enum class AlongAxis { up, x, y, z };

/// What the user may choose.
struct Options {
  double profile_layer = 0;      ///< thickness of the layers of the vertical profile [m]; 0: one mean radius
  double segregation_layer = 0;  ///< thickness of the layers of the segregation index [m]; 0: one mean diameter
  double segregation_cell = 0;   ///< edge of the cells of the segregation index [m]; 0: three mean diameters
  int segregation_rings = 0;     ///< rings of the segregation index; 0: by the size of the bed
  ShareBy segregation_by = ShareBy::volume;
  AlongAxis segregation_axis = AlongAxis::up;  ///< of the layers and of the rings
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
