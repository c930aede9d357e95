// What a head-on impact of one pair does, by the scene's normal law: for telling before a run.
#pragma once

#include "core/scene.hpp"
#include "engine/contact/normal_force.hpp"

namespace packstone::engine {

struct Impact {
  double duration = 0;         ///< [s]
  double restitution = 0;      ///< 0 where the bodies do not part
  double largest_overlap = 0;  ///< [m]
};

/// Integrates m_eff xi'' = -F_n(xi, xi') from first touch at a speed [m/s] in some 2,000 steps; attraction is left out.
Impact impact_of(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b, const PairSize<double>& size,
                 double speed);

}  // namespace packstone::engine
