// Who touches whom, as rows of the snapshot: read from the snapshot, or rebuilt from its geometry.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/neighbours.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// A particle that touches a boundary.
struct WallContact {
  std::uint32_t row;
  std::uint32_t boundary;
  double overlap;  ///< [m]
};

/// Contacts are where surfaces overlap (overlap > 0); a force across a gap makes none.
struct ContactNetwork {
  std::vector<NearPair> pairs;  ///< particle with particle, each once
  std::vector<WallContact> walls;
  bool rebuilt = false;  ///< from geometry, since the snapshot holds no contacts

  /// One sentence for the output's notes.
  std::string source() const;
};

/// From snapshot.contacts where they are; else every pair of overlapping spheres over the nearest periodic image,
/// and every sphere that crosses a plane boundary. Throws InputError when a contact names a particle or a boundary
/// that the snapshot does not hold.
ContactNetwork contact_network(const Snapshot& snapshot);

/// (N) contacts with particles of every particle.
std::vector<int> particle_contacts(const ContactNetwork& network, std::size_t particles);

/// (N) contacts of every particle with particles and boundaries.
std::vector<int> all_contacts(const ContactNetwork& network, std::size_t particles);

}  // namespace packstone::analysis
