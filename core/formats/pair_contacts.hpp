// Contacts from lists of pairs of particles and of particles at walls, as other programs write them.
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
  bool with_friction = true;                     ///< else the forces are normal parts alone
};

/// Contacts between particles: normal, overlap and point from the spheres over the nearest periodic image, the force
/// from the file, friction's limit not known; in the order of the rows of their particles. Pairs that neither overlap
/// nor have a force are left out, and a pair that occurs again. A pair that presses but lies apart by less than 1e-3 of
/// its radii, as few digits leave it, touches with an overlap of 1e-12 of them. A centre means the particle whose own
/// centre lies within 1e-3 of its radius of it; pairs with a centre that is no particle's (a wall's) are left out.
/// Throws InputError "FILE:LINE: what" where a pair names a particle that the snapshot does not hold, or twice the
/// same, or two that are farther apart than their diameters.
Contacts contacts_of_pairs(const Snapshot& snapshot, const PairForces& pairs);

/// Contacts of a file with walls. Particles by id, or by where their centres are.
struct WallForces {
  std::string source;              ///< the file, for messages
  std::int64_t first_line = 0;     ///< of the first contact, the others on the lines after it
  std::vector<std::int32_t> wall;  ///< (M) number of the wall, counted from 0
  std::vector<std::int64_t> id;    ///< (M); empty where particles go by their centres
  std::vector<Vec3> centre;        ///< (M) of the particle [m]; empty where particles go by id
  std::vector<Vec3> point;         ///< (M) where it touches [m]
  std::vector<Vec3> force;         ///< (M) on the particle [N]
};

/// Contacts with walls as the snapshot keeps them: wall k is boundary k, the normal leads from the point of contact to
/// the centre over the nearest periodic image, the overlap is the radius less their distance. Order, contacts left out
/// and friction as above; a particle may touch a wall at several points. Throws InputError "FILE:LINE: what" where a
/// particle is not in the snapshot, or the point lies farther from its centre than its diameter, or at it.
Contacts contacts_with_walls(const Snapshot& snapshot, const WallForces& walls);

}  // namespace packstone::formats
