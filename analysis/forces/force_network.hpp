// Contacts with their forces, by rows of the snapshot.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone::analysis {

/// One stored contact.
struct ForceContact {
  std::uint32_t first = 0;
  std::uint32_t second = 0;    ///< wall where the partner is a boundary
  Vec3 branch = Vec3::Zero();  ///< from the second's centre, or from the boundary's surface, to the first's centre [m]
  double first_share = 0;      ///< part of the branch that lies in the first particle: r1 / (r1 + r2), 1 at a boundary

  static constexpr std::uint32_t wall = std::numeric_limits<std::uint32_t>::max();
  bool at_wall() const { return second == wall; }
};

/// All contacts that the snapshot stores a force for, across a gap or not, in its order.
struct ForceNetwork {
  std::vector<ForceContact> contacts;  ///< (M) row k is row k of snapshot.contacts
  std::string missing;                 ///< why there are none; empty where there are

  std::size_t size() const { return contacts.size(); }
};

/// Branches are taken over the nearest periodic image; at a boundary the branch is (radius - overlap) n.
/// Throws InputError when a contact names a particle that the snapshot does not hold.
ForceNetwork force_network(const Snapshot& snapshot);

/// F.n of a stored contact, pressing positive [N].
inline double normal_force(const Contacts& contacts, std::size_t k) {
  return contacts.force[k].dot(contacts.normal[k]);
}

/// |F - (F.n) n| of a stored contact [N].
inline double tangential_force(const Contacts& contacts, std::size_t k) {
  return (contacts.force[k] - normal_force(contacts, k) * contacts.normal[k]).norm();
}

}  // namespace packstone::analysis
