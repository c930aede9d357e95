#include "engine/contact/mixing.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contact/collision.hpp"

namespace packstone::engine {

namespace {

/// (1 - nu^2)/E, how far a half space gives way [1/Pa].
double compliance(const MaterialSpec& m) { return (1 - *m.poisson_ratio * *m.poisson_ratio) / *m.young_modulus; }

/// (2 - nu)/G, the same for tangential loads [1/Pa].
double tangential_compliance(const MaterialSpec& m) {
  const double shear_modulus = *m.young_modulus / (2 * (1 + *m.poisson_ratio));
  return (2 - *m.poisson_ratio) / shear_modulus;
}

double mixed_restitution(double a, double b) { return std::sqrt(a * b); }

double mixed_friction(const MaterialSpec& a, const MaterialSpec& b) { return std::sqrt(a.friction * b.friction); }

/// Share of critical damping that gives the pair's restitution.
double damping_ratio(const ContactSpec& contact, const MaterialSpec& a, const MaterialSpec& b) {
  return linear_damping_ratio(mixed_restitution(*a.restitution, *b.restitution), contact.release);
}

template <class Parameters>
void set_linear(Parameters& pair, const ContactSpec& contact, const MaterialSpec& a, const MaterialSpec& b) {
  pair.stiffness = in_series(*a.normal_stiffness, *b.normal_stiffness);
  if (a.restitution && b.restitution) {
    pair.damping_per_root_mass = 2 * damping_ratio(contact, a, b) * std::sqrt(pair.stiffness);
  } else {
    pair.damping = in_series(*a.normal_damping, *b.normal_damping);
  }
}

/// Fills in the chosen law's parameters; the rest stays 0.
template <class Chosen>
void set_chosen(typename Chosen::template Parameters<double>& pair, const ContactSpec& contact, const MaterialSpec& a,
                const MaterialSpec& b) {
  Chosen(contact).with_law([&](auto law) {
    typename decltype(law)::template Parameters<double> own{};
    set_pair(own, contact, a, b);
    const auto values = numbers_of(own);
    std::copy(values.begin(), values.end(), pair.numbers.begin());
  });
}

}  // namespace

double in_series(double a, double b) { return a + b > 0 ? 2 * a * b / (a + b) : 0; }

double effective_modulus(const MaterialSpec& a, const MaterialSpec& b) { return 1 / (compliance(a) + compliance(b)); }

double dissipation_time(const MaterialSpec& m) {
  if (m.dissipation_time) return *m.dissipation_time;
  const double nu = *m.poisson_ratio, eta_1 = *m.shear_viscosity, eta_2 = *m.bulk_viscosity;
  const double viscosity = (3 * eta_2 - eta_1) * (3 * eta_2 - eta_1) / (3 * eta_2 + 2 * eta_1);
  return viscosity / 3 * (1 - nu * nu) * (1 - 2 * nu) / (*m.young_modulus * nu * nu);
}

void set_pair(Linear<Release::zero_overlap>::Parameters<double>& pair, const ContactSpec& contact,
              const MaterialSpec& a, const MaterialSpec& b) {
  set_linear(pair, contact, a, b);
}

void set_pair(Linear<Release::zero_force>::Parameters<double>& pair, const ContactSpec& contact, const MaterialSpec& a,
              const MaterialSpec& b) {
  set_linear(pair, contact, a, b);
}

void set_pair(Hertz::Parameters<double>& pair, const ContactSpec& contact, const MaterialSpec& a,
              const MaterialSpec& b) {
  pair.modulus = effective_modulus(a, b);
  if (a.restitution && b.restitution) {
    // In xi^(5/4) and a time that runs as xi^(1/4) the contact is the linear one, at alpha/sqrt(5) of critical damping
    // (Antypov & Elliott, EPL 94 (2011) 50004).
    pair.alpha = std::sqrt(5.0) * damping_ratio(contact, a, b);
  } else {
    pair.damping = in_series(*a.normal_damping, *b.normal_damping);
  }
}

void set_pair(KuwabaraKono::Parameters<double>& pair, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b) {
  pair.modulus = effective_modulus(a, b);
  pair.dissipation_time =
      (compliance(a) * dissipation_time(a) + compliance(b) * dissipation_time(b)) / (compliance(a) + compliance(b));
}

void set_pair(WaltonBraun::Parameters<double>& pair, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b) {
  const auto restitution = [](const MaterialSpec& m) {
    return m.restitution ? *m.restitution : std::sqrt(*m.normal_stiffness / *m.unloading_stiffness);
  };
  const double e = mixed_restitution(restitution(a), restitution(b));
  pair.loading = in_series(*a.normal_stiffness, *b.normal_stiffness);
  pair.unloading = pair.loading / (e * e);
}

void set_pair(Hysteretic::Parameters<double>& pair, const ContactSpec& contact, const MaterialSpec& a,
              const MaterialSpec& b) {
  const auto restitution = [](const MaterialSpec& m) {
    return m.restitution ? *m.restitution : hysteretic_restitution(*m.normal_damping);
  };
  pair.stiffness = in_series(*a.normal_stiffness, *b.normal_stiffness);
  pair.damping = hysteretic_damping(mixed_restitution(restitution(a), restitution(b)));
  pair.inverse_sign_speed = contact.sign_speed > 0 ? 1 / contact.sign_speed : Hysteretic::steepest_sign;
}

void set_pair(ChosenNormal::Parameters<double>& pair, const ContactSpec& contact, const MaterialSpec& a,
              const MaterialSpec& b) {
  set_chosen<ChosenNormal>(pair, contact, a, b);
}

void set_pair(Coulomb::Parameters<double>& pair, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b) {
  pair.friction = mixed_friction(a, b);
}

void set_pair(HaffWerner::Parameters<double>& pair, const ContactSpec&, const MaterialSpec& a, const MaterialSpec& b) {
  pair.damping = in_series(*a.tangential_damping, *b.tangential_damping);
  pair.friction = mixed_friction(a, b);
}

void set_pair(CundallStrack::Parameters<double>& pair, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b) {
  pair.stiffness = in_series(*a.tangential_stiffness, *b.tangential_stiffness);
  pair.friction = mixed_friction(a, b);
}

void set_pair(MindlinDeresiewicz::Parameters<double>& pair, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b) {
  pair.modulus = 1 / (tangential_compliance(a) + tangential_compliance(b));
  pair.friction = mixed_friction(a, b);
}

void set_pair(WaltonBraunTangential::Parameters<double>& pair, const ContactSpec&, const MaterialSpec& a,
              const MaterialSpec& b) {
  pair.stiffness = in_series(*a.tangential_stiffness, *b.tangential_stiffness);
  pair.friction = mixed_friction(a, b);
}

void set_pair(ChosenTangential::Parameters<double>& pair, const ContactSpec& contact, const MaterialSpec& a,
              const MaterialSpec& b) {
  set_chosen<ChosenTangential>(pair, contact, a, b);
}

}  // namespace packstone::engine
