// Closed forms of a head-on collision: durations, restitutions and what damping gives a restitution.
// Zhong et al., Acta Phys. Sin. 58 (2009), eqs [7], [8]; Schwager & Poeschel, Granular Matter 9 (2007) 465.
#pragma once

#include "core/scene.hpp"

namespace packstone::engine {

/// Contact time of two bodies on an undamped spring, half a period [s]. k [N/m], m_eff [kg].
double undamped_contact_time(double stiffness, double effective_mass);

/// Restitution of the linear law at a share zeta of critical damping, g = 2 zeta sqrt(k m_eff); 0 <= zeta < 1.
double linear_restitution(double damping_ratio, Release release);

/// Damping ratio that gives a restitution, the inverse of linear_restitution; 0 < e <= 1.
double linear_damping_ratio(double restitution, Release release);

/// Restitution sqrt((1-g)/(1+g)) of hysteretic damping, and its inverse.
double hysteretic_restitution(double damping);
double hysteretic_damping(double restitution);

}  // namespace packstone::engine
