// Contacts from lists of pairs of particles, as other programs write them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone::formats {

/// Pairs of a file, each with the force on its first particle. Particles by id, or by where their centres are.
struct PairForces {
  std::string source;           ///< the file, for messages
  std::int64_t first_line = 0;  ///< of the first pair, the others on the lines after it; 0: the file has no lines
  std::vector<std::array<std::int64_t, 2>> ids;  ///< (M); empty where particles go by their centres
  std::vector<std::array<Vec3, 2>> centres;      ///< (M) [m]; empty where particles go by id
  std::vector<Vec3> force;                       ///< (M) on the first [N]
};

/// Contacts between particles: normal, overlap and point from the spheres over the nearest periodic image, the force
/// from the file, friction's limit not known. Pairs that neither overlap nor have a force are left out, and a pair that
/// occurs again. A centre means the particle whose own centre lies within 1e-3 of its radius of it; pairs with a centre
/// that is no particle's (a wall's) are left out.
/// Throws InputError "FILE:LINE: what" where a pair names a particle that the snapshot does not hold, or twice the
/// same, or two that are farther apart than their diameters.
Contacts contacts_of_pairs(const Snapshot& snapshot, const PairForces& pairs);

}  // namespace packstone::formats
