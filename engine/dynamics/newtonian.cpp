// The one place where a scene's choice of laws becomes code.

#include <algorithm>

#include "engine/contact/chosen_normal.hpp"
#include "engine/contact/chosen_tangential.hpp"
#include "engine/contact/hysteretic.hpp"
#include "engine/contact/linear.hpp"
#include "engine/dynamics/newtonian_with.hpp"
#include "engine/dynamics/precision.hpp"
#include "engine/simd/lanes.hpp"

namespace packstone::engine {

void StepSums::add(const StepSums& other) {
  dissipated_normal += other.dissipated_normal;
  dissipated_tangential += other.dissipated_tangential;
  dissipated_resistance += other.dissipated_resistance;
  growth_work += other.growth_work;
  wall_work += other.wall_work;
  gravity_work += other.gravity_work;
  largest_share_squared = std::max(largest_share_squared, other.largest_share_squared);
  if (!offence) offence = other.offence;
  kinetic_translational += other.kinetic_translational;
  kinetic_rotational += other.kinetic_rotational;
  elastic += other.elastic;
  attractive += other.attractive;
  largest_overlap_share = std::max(largest_overlap_share, other.largest_overlap_share);
  largest_speed_squared = std::max(largest_speed_squared, other.largest_speed_squared);
  particle_contacts += other.particle_contacts;
  wall_contacts += other.wall_contacts;
  unbalanced_force = std::max(unbalanced_force, other.unbalanced_force);
}

bool rotates(const Scene& scene) {
  return scene.contact.tangential != TangentialModel::none &&
         std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& m) { return m.friction > 0; });
}

bool has_own_loop(const Scene& scene) {
  const ContactSpec& c = scene.contact;
  return (c.normal == NormalModel::linear || c.normal == NormalModel::hysteretic) &&
         (!rotates(scene) || c.tangential == TangentialModel::cundall_strack) && !c.van_der_waals.present;
}

namespace {

template <class Precision>
std::unique_ptr<Dynamics> newtonian_in(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  if (!has_own_loop(scene)) return newtonian_with<ChosenNormal, ChosenTangential, Precision>(scene, domain, boundaries);
  if (scene.contact.normal == NormalModel::hysteretic) {
    return newtonian_with<Hysteretic, CundallStrack, Precision>(scene, domain, boundaries);
  }
  return scene.contact.release == Release::zero_force
             ? newtonian_with<Linear<Release::zero_force>, CundallStrack, Precision>(scene, domain, boundaries)
             : newtonian_with<Linear<Release::zero_overlap>, CundallStrack, Precision>(scene, domain, boundaries);
}

}  // namespace

std::unique_ptr<Dynamics> make_newtonian(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  return scene.dynamics.precision == Precision::mixed
             ? newtonian_in<MixedPrecision<simd::WidestSingle>>(scene, domain, boundaries)
             : newtonian_in<DoublePrecision<simd::Widest>>(scene, domain, boundaries);
}

}  // namespace packstone::engine
