// Pairs of particles near each other, in O(N) at any size ratio.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/domain.hpp"
#include "core/vec3.hpp"

namespace packstone::analysis {

/// Two particles by row, with what their spheres share.
struct NearPair {
  std::uint32_t first;
  std::uint32_t second;
  double overlap;  ///< r1 + r2 - distance [m]; negative: the gap
};

/// All pairs whose surfaces are nearer than gap [m] (0: spheres that overlap), each once, over the nearest periodic
/// image: a periodic side must be longer than twice the reach of any pair, else further images are not seen.
/// The smaller particle comes first, of equal ones the lower row. In parallel; the pairs stand in an order that depends
/// on the rows alone.
///
/// Hierarchical grid (size_levels): a particle looks for partners in its own level and all coarser ones.
/// Source: He, Dong, Zhou, Phys. Rev. E 75 (2007) 036710.
std::vector<NearPair> near_pairs(std::span<const Vec3> position, std::span<const double> radius, const Domain& domain,
                                 double gap = 0);

}  // namespace packstone::analysis
