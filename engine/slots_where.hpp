// The particles of which something holds.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

/// Slots of particles, ascending.
template <class Holds>
std::vector<std::size_t> slots_where(const Particles& particles, const Holds& holds) {
  std::vector<std::size_t> slots;
  for (std::size_t slot = 0; slot < particles.slots(); ++slot) {
    if (particles.is_particle(slot) && holds(slot)) slots.push_back(slot);
  }
  return slots;
}

}  // namespace packstone::engine
