#include "engine/dynamics/overdamped_system.hpp"

#include <cmath>
#include <numbers>

#include "engine/block_sum.hpp"
#include "engine/filling/growth.hpp"

namespace packstone::engine {

double resistance(const Scene& scene, std::size_t group, double radius) {
  const ResistanceSpec& own = scene.particles[group].resistance;
  const ResistanceSpec& r = own.given() ? own : scene.dynamics.resistance;
  return r.coefficient ? *r.coefficient : 6 * std::numbers::pi * radius * *r.fluid_viscosity;
}

OverdampedSystem::OverdampedSystem(const Scene& scene, const Domain& domain, Boundaries& boundaries)
    : scene_(scene),
      boundaries_(boundaries),
      gravity_(scene),
      field_(scene.contact.normal == NormalModel::hertz ? make_hertz_forces(scene, domain, boundaries)
                                                        : make_linear_forces(scene, domain, boundaries)) {}

void OverdampedSystem::take(Particles& particles) {
  particles_ = &particles;
  mobility_.assign(particles.slots(), 0.0);
  for_each_index(particles.slots(), [&](std::size_t s) {
    if (!particles.is_particle(s)) return;
    mobility_[s] = 1 / resistance(scene_, static_cast<std::size_t>(particles.type[s]), particles.now.rows[s].radius);
  });
  mean_radius_ = sum_in_blocks<double>(
                     particles.slots(), 0.0,
                     [&](std::size_t s) { return particles.is_particle(s) ? particles.now.rows[s].radius : 0.0; }) /
                 static_cast<double>(std::max<std::size_t>(particles.size(), 1));
}

void OverdampedSystem::archive(Archive& a, Particles& particles) {
  a(instant_, gravity_now_, evaluations_);
  field_->archive(a, particles);
  if (a.reads() && field_->neighbours().builds() > 0) take(particles);
}

void OverdampedSystem::go_to(double time, double dt) {
  if (time == instant_) return;
  instant_ = time;
  boundaries_.go_to(time, dt, 0);
  gravity_now_ = gravity_.at(time);
}

StepSums OverdampedSystem::velocities(double time, double dt, const SlotVectors& x, SlotVectors& v) {
  go_to(time, dt);
  Particles& p = *particles_;
  for_each_index(slots(), [&](std::size_t s) {
    if (mobility_[s] > 0) p.now.rows[s].position = x[s];
  });
  const StepInput input{dt, growth_at(scene_, time), gravity_now_, scene_.monitor.overlap_limit, 0.0};
  const StepSums sums = field_->find(p, input, nullptr);
  ++evaluations_;
  v.resize(slots());
  for_each_index(slots(), [&](std::size_t s) {
    v[s] = mobility_[s] > 0 ? Vec3(mobility_[s] * (p.force.get(s) + weight(s))) : Vec3::Zero();
  });
  return sums;
}

const ContactMatrix& OverdampedSystem::linearised(double time) {
  field_->linearise(*particles_, growth_at(scene_, time).scale, matrix_);
  return matrix_;
}

double OverdampedSystem::size_of(const SlotVectors& displacements) const {
  const double squared =
      sum_in_blocks<double>(displacements.size(), 0.0, [&](std::size_t s) { return displacements[s].squaredNorm(); });
  return std::sqrt(squared / static_cast<double>(std::max<std::size_t>(particles_->size(), 1))) / mean_radius_;
}

}  // namespace packstone::engine
