// Overdamped motion as a system of ordinary differential equations, Revuzhenko, Klishin & Mikenina, Fiz. Mezomekh. 17
// (2014): mu_i dx_i/dt = sum_j F_ij + m_i g.
#pragma once

#include <memory>
#include <vector>

#include "core/scene.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/dynamics/contact_matrix.hpp"
#include "engine/dynamics/force_field.hpp"
#include "engine/gravity.hpp"

namespace packstone::engine {

/// mu of a particle of a group: the group's or the scene's, at full size [N s/m].
double resistance(const Scene& scene, std::size_t group, double radius);

/// What integrators see. Vectors are by slot; empty slots have no mobility and stay where they are.
class OverdampedSystem {
 public:
  /// The boundaries must outlive it.
  OverdampedSystem(const Scene& scene, const Domain& domain, Boundaries& boundaries);

  /// The particles of the coming calls; to be told again after each rebuild.
  void take(Particles& particles);

  /// Velocities of particles at x, whose forces stay in the particles. dt: since the boundaries' instant before [s].
  StepSums velocities(double time, double dt, const SlotVectors& x, SlotVectors& v);
  /// How the forces last found change; by its entries alone where x was not changed since.
  const ContactMatrix& linearised(double time);

  /// As Dynamics::archive.
  void archive(Archive& a, Particles& particles);

  std::size_t slots() const { return mobility_.size(); }
  /// 1/mu by slot [m/(N s)].
  const std::vector<double>& mobility() const { return mobility_; }
  /// Root mean square over the particles, as a share of the mean radius.
  double size_of(const SlotVectors& displacements) const;
  /// Boundaries and gravity may have changed at the instant that they are at.
  void forget_instant() { instant_ = -1; }
  double radius(std::size_t slot) const { return particles_->now.rows[slot].radius; }    ///< at full size [m]
  Vec3 weight(std::size_t slot) const { return particles_->mass[slot] * gravity_now_; }  ///< [N]

  ForceField& field() const { return *field_; }
  const Boundaries& boundaries() const { return boundaries_; }
  std::int64_t evaluations() const { return evaluations_; }

 private:
  void go_to(double time, double dt);

  Scene scene_;
  Boundaries& boundaries_;
  Gravity gravity_;
  std::unique_ptr<ForceField> field_;
  Particles* particles_ = nullptr;
  std::vector<double> mobility_;
  ContactMatrix matrix_;
  double mean_radius_ = 0;
  double instant_ = -1;  ///< of the boundaries [s]; -1: unknown
  Vec3 gravity_now_ = Vec3::Zero();
  std::int64_t evaluations_ = 0;
};

}  // namespace packstone::engine
