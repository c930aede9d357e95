// How stiff and how damped a contact may become: what the time step must follow.
#pragma once

#include "core/scene.hpp"
#include "engine/contact/normal_force.hpp"

namespace packstone::engine {

/// Of one pair, at its steepest up to a given overlap.
struct ContactScales {
  double stiffness = 0;             ///< slope of the elastic force over overlap [N/m]
  double steepest = 0;              ///< the same with what the law adds on loading or unloading [N/m]
  double tangential_stiffness = 0;  ///< [N/m]; 0 without friction or without springs
  double attraction_slope = 0;      ///< of van der Waals' force over the gap, at the smallest [N/m]
  double damping = 0;               ///< of the normal dashpot [N s/m]
  double tangential_damping = 0;    ///< [N s/m]
};

/// overlap [m]: the deepest that the run lets pass; laws whose stiffness grows with it are taken there.
ContactScales contact_scales(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b,
                             const PairSize<double>& size, double overlap);

}  // namespace packstone::engine
