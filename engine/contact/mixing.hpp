// The mixing rules of docs/physics.md: what the laws' parameters are for two materials in contact.
#pragma once

#include "core/scene.hpp"
#include "engine/contact/chosen_normal.hpp"
#include "engine/contact/chosen_tangential.hpp"
#include "engine/contact/cundall_strack.hpp"
#include "engine/contact/frictionless.hpp"
#include "engine/contact/hysteretic.hpp"
#include "engine/contact/linear.hpp"

namespace packstone::engine {

/// Springs and dashpots act in series, scaled so that equal bodies keep their own value: 2 a b / (a + b); 0 with
/// either.
double in_series(double a, double b);

/// E_eff of Hertz' contact, eq. [12] of Zhong et al. (2009) [Pa].
double effective_modulus(const MaterialSpec& a, const MaterialSpec& b);

/// B of viscoelastic spheres of one material, from its viscosities where it gives them: Brilliantov, Spahn, Hertzsch &
/// Poeschel, Phys. Rev. E 53 (1996) 5382, with the square that eq. [15] of Zhong et al. (2009) leaves out [s].
double dissipation_time(const MaterialSpec& material);

/// Fill the parameters of a law for two materials in contact. Restitutions mix as sqrt(e_i e_j) and turn into damping
/// for the pair, so that unequal masses come out right; friction mixes as sqrt(mu_i mu_j).
void set_pair(Linear<Release::zero_overlap>::Parameters<double>&, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b);
void set_pair(Linear<Release::zero_force>::Parameters<double>&, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b);
void set_pair(Hertz::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);
/// The bodies' deformations share B in proportion to their compliances (1 - nu^2)/E.
void set_pair(KuwabaraKono::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(WaltonBraun::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(Hysteretic::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(ChosenNormal::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);

inline void set_pair(Frictionless::Parameters<double>&, const ContactSpec&, const MaterialSpec&, const MaterialSpec&) {}
void set_pair(Coulomb::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(HaffWerner::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(CundallStrack::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(MindlinDeresiewicz::Parameters<double>&, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b);
void set_pair(WaltonBraunTangential::Parameters<double>&, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b);
void set_pair(ChosenTangential::Parameters<double>&, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b);

}  // namespace packstone::engine
