// What the user may choose about the measures.
#pragma once

#include <vector>

#include "analysis/packing/region.hpp"

namespace packstone::analysis {

/// What joins particles into clusters.
struct ClusterOptions {
  double gap = 0;          ///< spheres whose surfaces are nearer [m]; 0: contacts
  double least_force = 0;  ///< only contacts that press harder, over the mean normal force; 0: all
  bool any_type = false;   ///< particles of different types, too
};

/// Kernels of coarse-graining (forces/kernel.hpp).
enum class Kernel { lucy, gaussian };

/// What the user may choose about forces.
struct ForceOptions {
  double chain_threshold = 1;  ///< stress above which a particle can be in a force chain, in means
  double chain_angle = 45;     ///< largest angle of a chain's link to the stress of its particles [degrees]
  Kernel kernel = Kernel::lucy;
  double kernel_width = 0;  ///< standard deviation of the kernel along an axis [m]; 0: one mean radius
  double coarse_cell = 0;   ///< width of the cells of the coarse-grained fields' grid [m]; 0: two kernel widths
  double resolution = 1;    ///< gamma of the communities: larger values give smaller communities
};

/// What the shares of the types are of.
enum class ShareBy { number, volume, mass };

/// Up as the snapshot has it, or an axis of the domain.
enum class AlongAxis { up, x, y, z };

/// What the user may choose.
struct Options {
  double profile_layer = 0;      ///< thickness of the layers of the vertical profile [m]; 0: one mean radius
  double segregation_layer = 0;  ///< thickness of the layers of the segregation index [m]; 0: one mean diameter
  ClusterOptions clusters = {};
  std::vector<NamedRegion> regions = {};  ///< whose solid fraction is wanted
  double interior_margin = 2;             ///< from walls and surface to the interior, in volume-mean diameters
  double wall_layer = 0;     ///< width of the rings and shells of the side walls' profiles [m]; 0: one mean radius
  double surface_probe = 0;  ///< radius of the ball that rolls over the surface [m]; 0: the volume-mean radius
  double surface_step = 0;   ///< between the surface's columns [m]; 0: an eighth of the smaller of those two radii
  double map_cell = 0;       ///< width of the cells of the fraction map [m]; 0: one volume-mean diameter
  ForceOptions forces = {};
  double segregation_cell = 0;  ///< edge of the cells of the segregation index [m]; 0: three mean diameters
  int segregation_rings = 0;    ///< rings of the segregation index; 0: by the size of the bed
  ShareBy segregation_by = ShareBy::volume;
  AlongAxis segregation_axis = AlongAxis::up;  ///< of the layers and of the rings
  double rdf_range = 0;                        ///< of the radial distribution function [m]; 0: five mean diameters
  double rdf_bin = 0;                          ///< width of its bins [m]; 0: a twentieth of the mean diameter
  double bond_cutoff = 1.3;    ///< bonds of the bond order: centres nearer than so many times the sum of the radii
  int bond_neighbours = 0;     ///< bonds with so many nearest neighbours instead; 0: by bond_cutoff
  int pore_points = 100'000;   ///< random points for the pore sizes
  bool voronoi_cells = false;  ///< measure voronoi also lists every cell
};

/// Throws InputError that names the option out of range.
void check_options(const Options& options);

}  // namespace packstone::analysis
