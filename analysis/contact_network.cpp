#include "analysis/contact_network.hpp"

#include "analysis/row_of_id.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

ContactNetwork stored(const Snapshot& snapshot, const Contacts& contacts) {
  const RowOfId row_of(snapshot.id);
  ContactNetwork network;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const bool touching = contacts.overlap[k] > 0;
    const std::uint32_t first = row_of.at(contacts.first[k]);
    if (contacts.second[k] >= 0) {
      const std::uint32_t second = row_of.at(contacts.second[k]);
      if (touching) network.pairs.push_back({first, second, contacts.overlap[k]});
      continue;
    }
    const auto boundary = static_cast<std::size_t>(-1 - contacts.second[k]);
    if (boundary >= snapshot.boundaries.size()) {
      throw InputError("a contact names boundary " + std::to_string(boundary) + ", but the snapshot holds " +
                       std::to_string(snapshot.boundaries.size()));
    }
    if (touching) network.walls.push_back({first, static_cast<std::uint32_t>(boundary), contacts.overlap[k]});
  }
  return network;
}

ContactNetwork rebuilt(const Snapshot& snapshot) {
  ContactNetwork network;
  network.rebuilt = true;
  network.pairs = near_pairs(snapshot.position, snapshot.radius, snapshot.domain);
  for (std::size_t k = 0; k < snapshot.boundaries.size(); ++k) {
    const BoundaryRecord& plane = snapshot.boundaries[k];
    if (plane.kind != "plane" || plane.normal.isZero(0)) continue;  // or not there at the time
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
      const double overlap = snapshot.radius[i] - plane.normal.dot(snapshot.position[i] - plane.point);
      if (overlap > 0) network.walls.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k), overlap});
    }
  }
  return network;
}

}  // namespace

std::string ContactNetwork::source() const { return rebuilt ? "contacts rebuilt from geometry" : ""; }

ContactNetwork contact_network(const Snapshot& snapshot) {
  return snapshot.contacts ? stored(snapshot, *snapshot.contacts) : rebuilt(snapshot);
}

std::vector<int> particle_contacts(const ContactNetwork& network, std::size_t particles) {
  std::vector<int> count(particles, 0);
  for (const auto& pair : network.pairs) {
    ++count[pair.first];
    ++count[pair.second];
  }
  return count;
}

std::vector<int> all_contacts(const ContactNetwork& network, std::size_t particles) {
  std::vector<int> count = particle_contacts(network, particles);
  for (const auto& wall : network.walls) ++count[wall.row];
  return count;
}

}  // namespace packstone::analysis
