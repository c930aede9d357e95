// Coarse-grained fields of mass, momentum and stress.
#pragma once

#include <vector>

#include "analysis/context.hpp"
#include "analysis/forces/force_network.hpp"
#include "analysis/forces/kernel.hpp"
#include "analysis/forces/stress.hpp"
#include "analysis/layers.hpp"

namespace packstone::analysis {

/// The fields at one place.
struct CoarseCell {
  double solid_fraction = 0;       ///< sum V phi
  double density = 0;              ///< sum m phi [kg/m3]
  Vec3 momentum = Vec3::Zero();    ///< sum m v phi [kg/(m2 s)]; 0 without velocity
  Mat3 contact = Mat3::Zero();     ///< sum_c f (x) l int_0^1 phi ds over the branch, compression positive [Pa]
  Mat3 kinetic = Mat3::Zero();     ///< sum m v' (x) v' phi, v' against momentum / density [Pa]
  Vec3 wall_force = Vec3::Zero();  ///< sum of the forces of boundaries on particles, phi at the contact [N/m3]
};

/// Which of the fields the snapshot has what it takes for; solid fractions always.
struct KnownFields {
  bool mass, velocity, forces;
};

KnownFields known_fields(const Snapshot& snapshot, const ForceNetwork& network);

/// Width of the kernel that the options ask for [m]: by default one mean radius, at most the domain along periodic
/// axes; 0 where all radii are 0. Throws InputError when the width asked for is larger than a periodic side.
double kernel_width(const Snapshot& snapshot, const Context& context);

/// (layers.count) Fields averaged over the whole cross-section and over each layer, exactly: the plane means of the
/// kernel integrated over the layer, so that sum density x area x thickness is the mass, to rounding, of what lies
/// within the stack. With v = 0: d(stress_up)/d(up) = -density g + wall_force.
/// Sources: Goldhirsch, Granular Matter 12 (2010) 239; boundaries: Weinhart et al., Granular Matter 14
/// (2012) 289.
std::vector<CoarseCell> coarse_profile(const Snapshot& snapshot, const BedFrame& frame, const ForceNetwork& network,
                                       const CoarseKernel& kernel, const Layers& layers);

/// Layers of the profile: of the wanted thickness, but not below a quarter of the kernel's width, and over the
/// kernel's range below the floor and above the top.
Layers coarse_layers(const BedFrame& frame, const std::vector<double>& radius, const CoarseKernel& kernel, double width,
                     double thickness);

}  // namespace packstone::analysis
