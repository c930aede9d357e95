// The one place where a scene's choice of laws becomes code.

#include <algorithm>

#include "engine/contact/hysteretic.hpp"
#include "engine/contact/linear.hpp"
#include "engine/dynamics/newtonian_with.hpp"
#include "engine/dynamics/precision.hpp"
#include "engine/simd/lanes.hpp"

namespace packstone::engine {

void StepSums::add(const StepSums& other) {
  dissipated += other.dissipated;
  growth_work += other.growth_work;
  gravity_work += other.gravity_work;
  largest_share_squared = std::max(largest_share_squared, other.largest_share_squared);
  if (!offence) offence = other.offence;
  kinetic_translational += other.kinetic_translational;
  kinetic_rotational += other.kinetic_rotational;
  elastic += other.elastic;
  largest_overlap_share = std::max(largest_overlap_share, other.largest_overlap_share);
  largest_speed_squared = std::max(largest_speed_squared, other.largest_speed_squared);
  particle_contacts += other.particle_contacts;
  wall_contacts += other.wall_contacts;
}

bool rotates(const Scene& scene) {
  return scene.contact.tangential != TangentialModel::none &&
         std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& m) { return m.friction > 0; });
}

std::vector<Plane> make_planes(const Scene& scene) {
  std::vector<Plane> planes;
  for (const auto& b : scene.boundaries) {
    planes.push_back({b.point, b.normal.normalized(), static_cast<std::size_t>(scene.material_index(b.material))});
  }
  return planes;
}

namespace {

template <class Precision>
std::unique_ptr<Dynamics> newtonian_in(const Scene& scene, const Domain& domain, const std::vector<Plane>& planes) {
  switch (scene.contact.normal) {
    case NormalModel::hysteretic:
      return newtonian_with<Hysteretic, Precision>(scene, domain, planes);
    case NormalModel::linear:
      break;
  }
  return scene.contact.release == Release::zero_force
             ? newtonian_with<Linear<Release::zero_force>, Precision>(scene, domain, planes)
             : newtonian_with<Linear<Release::zero_overlap>, Precision>(scene, domain, planes);
}

}  // namespace

std::unique_ptr<Dynamics> make_newtonian(const Scene& scene, const Domain& domain, const std::vector<Plane>& planes) {
  return scene.dynamics.precision == Precision::mixed
             ? newtonian_in<MixedPrecision<simd::WidestSingle>>(scene, domain, planes)
             : newtonian_in<DoublePrecision<simd::Widest>>(scene, domain, planes);
}

}  // namespace packstone::engine
