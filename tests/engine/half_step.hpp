// The velocities that the leapfrog scheme keeps, wherever the particles hold them.
#pragma once

#include "engine/dynamics/particles.hpp"

namespace packstone::engine::testing {

inline Vec3 half_step_velocity(const Particles& p, std::size_t slot) { return p.half_step_velocity(slot); }

inline Vec3 half_step_turning(const Particles& p, std::size_t slot) {
  return p.half_angular_velocity.empty() ? p.now.spins[slot].angular_velocity : p.half_angular_velocity.get(slot);
}

}  // namespace packstone::engine::testing
