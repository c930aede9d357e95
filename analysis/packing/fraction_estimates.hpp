// Solid fraction of a region in three ways, for studies of what each costs: exact volumes, points, voxels. Overlaps
// count twice in all of them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "analysis/context.hpp"
#include "analysis/packing/region.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// Where bulk_fraction is measured: from 10 % to 80 % of the bed's height, over the container's whole cross-section;
/// all of the domain where it is periodic along up. Throws InputError where there is no bed or its container is not
/// known.
RegionShape bulk_region(const Snapshot& snapshot, const Context& context);

/// Parts of the spheres in the region in closed form. Error: rounding.
double exact_fraction(const Snapshot& snapshot, const RegionShape& region);

/// Points that fill a region: independent and uniform, or an additive recurrence with a random start, which leaves no
/// gaps and no clusters (R_3 of M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
enum class PointSet { random, even };

/// Mean number of spheres that hold a point, over so many points. Error of random points: sqrt(f (1 - f) / points)
/// without overlaps; even points: less, by no law that holds for all.
double sampled_fraction(const Snapshot& snapshot, const RegionShape& region, std::size_t points, PointSet set,
                        std::uint64_t seed);

/// Voxels whose middle a sphere holds over those in the region, on a grid of edge h [m] with a random start. The
/// error of a sphere of radius R is of the order of (h/R)^2, as that of the points of a lattice in it, and falls with
/// the number of spheres. Throws InputError where no middle lies in the region or there are more than most_voxels.
double voxel_fraction(const Snapshot& snapshot, const RegionShape& region, double edge, std::uint64_t seed);

inline constexpr double most_voxels = 1e10;  ///< minutes

}  // namespace packstone::analysis
