#include "engine/contact/contact_scales.hpp"

#include <cmath>

#include "engine/contact/mixing.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

namespace {

template <class Law>
typename Law::template Coefficients<double> coefficients(const Scene& scene, const MaterialSpec& a,
                                                         const MaterialSpec& b, const PairSize<double>& size) {
  typename Law::template Parameters<double> pair{};
  set_pair(pair, scene.contact, a, b);
  return Law::coefficients(pair, size);
}

void add_normal(ContactScales& scales, const Scene& scene, const MaterialSpec& a, const MaterialSpec& b,
                const PairSize<double>& size, double overlap) {
  switch (scene.contact.normal) {
    case NormalModel::linear: {
      const auto pair = scene.contact.release == Release::zero_force
                            ? coefficients<Linear<Release::zero_force>>(scene, a, b, size).damping
                            : coefficients<Linear<Release::zero_overlap>>(scene, a, b, size).damping;
      scales.stiffness = scales.steepest = in_series(*a.normal_stiffness, *b.normal_stiffness);
      scales.damping = pair;
      return;
    }
    case NormalModel::hertz: {
      const auto pair = coefficients<Hertz>(scene, a, b, size);
      scales.stiffness = scales.steepest = 1.5 * pair.stiffness * std::sqrt(overlap);
      scales.damping = pair.damping + pair.damping_at_unit_overlap * std::sqrt(std::sqrt(overlap));
      return;
    }
    case NormalModel::kuwabara_kono: {
      const auto pair = coefficients<KuwabaraKono>(scene, a, b, size);
      scales.stiffness = scales.steepest = 1.5 * pair.stiffness * std::sqrt(overlap);
      scales.damping = scales.stiffness * pair.dissipation_time;
      return;
    }
    case NormalModel::walton_braun: {
      const auto pair = coefficients<WaltonBraun>(scene, a, b, size);
      scales.stiffness = scales.steepest = pair.unloading;
      return;
    }
    case NormalModel::hysteretic: {
      const auto pair = coefficients<Hysteretic>(scene, a, b, size);
      scales.stiffness = pair.stiffness;
      scales.steepest = pair.stiffness * (1 + pair.damping);
      return;
    }
  }
}

void add_tangential(ContactScales& scales, const Scene& scene, const MaterialSpec& a, const MaterialSpec& b,
                    const PairSize<double>& size, double overlap) {
  switch (scene.contact.tangential) {
    case TangentialModel::none:
    case TangentialModel::coulomb:
      return;
    case TangentialModel::haff_werner:
      scales.tangential_damping = in_series(*a.tangential_damping, *b.tangential_damping);
      return;
    case TangentialModel::cundall_strack:
    case TangentialModel::walton_braun:
      scales.tangential_stiffness = in_series(*a.tangential_stiffness, *b.tangential_stiffness);
      return;
    case TangentialModel::mindlin_deresiewicz:
      scales.tangential_stiffness = coefficients<MindlinDeresiewicz>(scene, a, b, size).stiffness * std::sqrt(overlap);
      return;
  }
}

}  // namespace

ContactScales contact_scales(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b,
                             const PairSize<double>& size, double overlap) {
  ContactScales scales;
  add_normal(scales, scene, a, b, size, overlap);
  if (rotates(scene)) add_tangential(scales, scene, a, b, size, overlap);
  const VanDerWaalsSpec& w = scene.contact.van_der_waals;
  if (w.present) scales.attraction_slope = w.hamaker * size.effective_radius / (3 * w.min_gap * w.min_gap * w.min_gap);
  return scales;
}

}  // namespace packstone::engine
