#include "engine/contact/pair_table.hpp"

#include <cmath>

#include "engine/contact/collision.hpp"

namespace packstone::engine {

namespace {

template <Release release>
void set_linear(typename Linear<release>::template Parameters<double>& pair, const MaterialSpec& a,
                const MaterialSpec& b) {
  pair.stiffness = in_series(a.normal_stiffness, b.normal_stiffness);
  if (a.restitution && b.restitution) {
    const double zeta = linear_damping_ratio(std::sqrt(*a.restitution * *b.restitution), release);
    pair.damping_per_root_mass = 2 * zeta * std::sqrt(pair.stiffness);
  } else {
    pair.damping = in_series(*a.normal_damping, *b.normal_damping);
  }
}

}  // namespace

double in_series(double a, double b) { return a + b > 0 ? 2 * a * b / (a + b) : 0; }

void set_pair(Linear<Release::zero_overlap>::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b) {
  set_linear<Release::zero_overlap>(pair, a, b);
}

void set_pair(Linear<Release::zero_force>::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b) {
  set_linear<Release::zero_force>(pair, a, b);
}

void set_pair(Hysteretic::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b) {
  const auto restitution = [](const MaterialSpec& m) {
    return m.restitution ? *m.restitution : hysteretic_restitution(*m.normal_damping);
  };
  pair.stiffness = in_series(a.normal_stiffness, b.normal_stiffness);
  pair.damping = hysteretic_damping(std::sqrt(restitution(a) * restitution(b)));
}

void set_pair(CundallStrack::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b) {
  pair.stiffness = in_series(*a.tangential_stiffness, *b.tangential_stiffness);
  pair.friction = std::sqrt(a.friction * b.friction);
}

double largest_damping(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b, double effective_mass) {
  if (scene.contact.normal != NormalModel::linear) return 0;
  const auto damping = [&](auto pair) {
    set_pair(pair, a, b);
    return pair.damping + pair.damping_per_root_mass * std::sqrt(effective_mass);
  };
  return scene.contact.release == Release::zero_force ? damping(Linear<Release::zero_force>::Parameters<double>{})
                                                      : damping(Linear<Release::zero_overlap>::Parameters<double>{});
}

double largest_stiffness(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b) {
  if (scene.contact.normal == NormalModel::hysteretic) {
    Hysteretic::Parameters<double> pair{};
    set_pair(pair, a, b);
    return pair.stiffness * (1 + pair.damping);
  }
  return in_series(a.normal_stiffness, b.normal_stiffness);
}

}  // namespace packstone::engine
