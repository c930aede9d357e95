#include "analysis/forces/force_network.hpp"

#include <utility>

#include "analysis/row_of_id.hpp"

namespace packstone::analysis {

namespace {

ForceContact at_boundary(const Snapshot& snapshot, std::uint32_t row, std::size_t k) {
  const Contacts& stored = *snapshot.contacts;
  return {row, ForceContact::wall, (snapshot.radius[row] - stored.overlap[k]) * stored.normal[k], 1};
}

ForceContact between(const Snapshot& snapshot, std::uint32_t first, std::uint32_t second) {
  const double r1 = snapshot.radius[first], r2 = snapshot.radius[second];
  return {first, second, snapshot.domain.separation(snapshot.position[first], snapshot.position[second]),
          r1 + r2 > 0 ? r1 / (r1 + r2) : 0.5};
}

}  // namespace

ForceNetwork force_network(const Snapshot& snapshot) {
  ForceNetwork network;
  if (!snapshot.contacts) network.missing = "the snapshot holds no contact forces";
  if (snapshot.contacts && snapshot.contacts->size() == 0) network.missing = "no contacts";
  if (!network.missing.empty()) return network;

  const Contacts& stored = *snapshot.contacts;
  const RowOfId row_of(snapshot.id);
  network.contacts.resize(stored.size());
  const auto partners_of = [&](std::size_t k) {
    return std::pair(stored.first[k], stored.second[k] < 0 ? stored.first[k] : stored.second[k]);
  };
  bool known = true;  // nothing may be thrown among the threads
#pragma omp parallel for reduction(&& : known)
  for (std::size_t k = 0; k < stored.size(); ++k) {
    const auto [first_id, second_id] = partners_of(k);
    const std::uint32_t first = row_of.find(first_id), second = row_of.find(second_id);
    if (first == RowOfId::no_row || second == RowOfId::no_row) {
      known = false;
    } else if (stored.second[k] < 0) {
      network.contacts[k] = at_boundary(snapshot, first, k);
    } else {
      network.contacts[k] = between(snapshot, first, second);
    }
  }
  for (std::size_t k = 0; k < stored.size() && !known; ++k) {
    const auto [first_id, second_id] = partners_of(k);
    row_of.at(first_id);
    row_of.at(second_id);
  }
  return network;
}

}  // namespace packstone::analysis
