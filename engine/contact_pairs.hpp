// The kinds of contact that a scene can have, each at its lightest.
#pragma once

#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/contact/normal_force.hpp"
#include "engine/filling/population.hpp"

namespace packstone::engine {

/// The smallest particle of a group that has any.
struct SmallestParticle {
  const GroupSpec* group;
  const MaterialSpec* material;
  double radius;  ///< [m]
  double mass;    ///< [kg]
};

std::vector<SmallestParticle> smallest_particles(const Scene& scene, const Population& population);

/// Two groups, or a group and a boundary.
struct ContactPair {
  std::string name;  ///< "light - heavy", "light - floor"
  const MaterialSpec* a;
  const MaterialSpec* b;
  PairSize<double> size;
  double smaller_radius;  ///< of the particles [m]

  double effective_mass() const { return 1 / size.inverse_mass_sum; }  ///< [kg]
};

/// Each pair of groups once, of each group its smallest particle, whose contacts are the shortest.
std::vector<ContactPair> contact_pairs(const Scene& scene, const Population& population);

}  // namespace packstone::engine
