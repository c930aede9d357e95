// What time step a scene allows.
#pragma once

#include <string>
#include <vector>

#include "core/scene.hpp"

namespace packstone::engine {

/// The contact that limits the step.
struct StepLimit {
  double limit = 0;           ///< 2/omega of that contact alone: beyond it the motion grows without bound [s]
  double recommended = 0;     ///< 0.17 sqrt(m/k), m = 2 m_eff: for contacts in a packing [s]
  double contact_time = 0;    ///< pi sqrt(m_eff/k_n), undamped [s]
  double stiffness = 0;       ///< steepest slope of the pair's force [N/m]
  double effective_mass = 0;  ///< [kg]
  std::string pair;           ///< "light - heavy", "light - floor"
};

/// The smallest over all pairs of groups and of groups with boundaries.
/// omega = sqrt(k/m_eff) with the law's steepest slope k; O'Sullivan & Bray, Eng. Comput. 21 (2004) 278 for 0.17.
StepLimit step_limit(const Scene& scene);

/// The step the run will take [s]: the scene's, or the recommended one for "auto".
/// Throws InputError beyond the limit. Appends a warning beyond the recommended step.
double checked_time_step(const Scene& scene, std::vector<std::string>& warnings);

}  // namespace packstone::engine
