// What time step a scene allows.
#pragma once

#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/filling/population.hpp"

namespace packstone::engine {

/// What the pairs of a scene allow; limit, contact time and pair are those of the tightest.
struct StepLimit {
  double limit = 0;           ///< beyond it a single contact's motion grows without bound [s]
  double recommended = 0;     ///< for contacts in a packing, the smallest over all pairs [s]
  double contact_time = 0;    ///< pi sqrt(m_eff/k_n), undamped [s]
  double stiffness = 0;       ///< steepest slope of the pair's force [N/m]
  double effective_mass = 0;  ///< [kg]
  std::string pair;           ///< "light - heavy", "light - floor"
};

/// Over all pairs of groups and of groups with boundaries, of each group its smallest particle, whose contacts are the
/// shortest:
/// limit        2/omega, omega^2 the larger of k_n/m_eff with the law's steepest slope k_n and, with friction,
///              3.5 k_s/m_eff (sliding turns a solid sphere as well); with a dashpot also m_eff/g, where the velocity
///              estimate of the scheme stops following it.
/// recommended  0.17 sqrt(m/k), m = 2 m_eff, k the larger of k_n and k_s (O'Sullivan & Bray, Eng. Comput. 21 (2004)
/// 278);
///              with a dashpot also half of m_eff/g.
StepLimit step_limit(const Scene& scene, const Population& population);

/// The step the run will take [s]: the scene's, or the recommended one for "auto".
/// Throws InputError beyond the limit. Appends a warning beyond the recommended step.
double checked_time_step(const Scene& scene, const StepLimit& limit, std::vector<std::string>& warnings);

}  // namespace packstone::engine
