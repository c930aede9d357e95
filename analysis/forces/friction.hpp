// Coefficients of friction of the contacts, from the scene that the snapshot carries.
#pragma once

#include <string>
#include <vector>

#include "analysis/forces/force_network.hpp"

namespace packstone::analysis {

/// Friction of every material and boundary, as the scene gives it.
struct FrictionTable {
  std::vector<double> material;  ///< by index into snapshot.material_names
  std::vector<double> boundary;  ///< by index into snapshot.boundaries
  std::string missing;           ///< why the coefficients are not known; empty where they are

  /// sqrt(mu_a mu_b) of the two partners, as the engine mixes them. row: of the contact.
  double coefficient(const Snapshot& snapshot, const ForceContact& contact, std::size_t row) const;
};

/// Not known where the snapshot carries no scene, or one that cannot be read or does not name its materials and
/// boundaries, and where the scene has no law of friction.
FrictionTable friction_table(const Snapshot& snapshot);

}  // namespace packstone::analysis
