// The step as one would write it for reading: every pair of particles, one after the other, plain vectors. The fast
// step is checked against it.
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "core/domain.hpp"
#include "core/scene.hpp"
#include "core/vec3.hpp"
#include "engine/boundary/plane.hpp"
#include "engine/contact/collision.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine::testing {

struct TwinSphere {
  Vec3 position, velocity, half_velocity, spin, half_spin;
  double radius, mass;
  int material;
};

class SlowTwin {
 public:
  SlowTwin(const Scene& scene, std::vector<TwinSphere> spheres)
      : scene_(scene), domain_(scene.box()), planes_(make_planes(scene)), spheres_(std::move(spheres)) {}

  const std::vector<TwinSphere>& spheres() const { return spheres_; }
  int contacts() const { return contacts_; }
  double dissipated() const { return dissipated_; }

  void step(const StepInput& in) {
    std::vector<Vec3> force(spheres_.size(), Vec3::Zero()), torque(spheres_.size(), Vec3::Zero());
    contacts_ = 0;
    dissipated_ = 0;
    for (std::size_t i = 0; i < spheres_.size(); ++i) {
      const TwinSphere& a = spheres_[i];
      for (std::size_t j = i + 1; j < spheres_.size(); ++j) {
        const TwinSphere& b = spheres_[j];
        const Vec3 d = domain_.separation(a.position, b.position);
        const double overlap = in.growth.scale * (a.radius + b.radius) - d.norm();
        const Load on_a = contact(a, b, {long(i), long(j)}, d.normalized(), overlap, in);
        force[i] += on_a.force;
        force[j] -= on_a.force;
        torque[i] -= in.growth.scale * a.radius * on_a.turning;
        torque[j] -= in.growth.scale * b.radius * on_a.turning;
      }
      for (std::size_t w = 0; w < planes_.size(); ++w) {
        TwinSphere wall{};
        wall.velocity = wall.spin = Vec3::Zero();
        wall.material = static_cast<int>(planes_[w].material);
        const double overlap = in.growth.scale * a.radius - planes_[w].distance(a.position);
        const Load on_a = contact(a, wall, {long(i), -1 - long(w)}, planes_[w].normal, overlap, in);
        force[i] += on_a.force;
        torque[i] -= in.growth.scale * a.radius * on_a.turning;
      }
    }
    for (std::size_t i = 0; i < spheres_.size(); ++i) {
      TwinSphere& a = spheres_[i];
      const Vec3 acceleration = force[i] / a.mass + in.gravity;
      const Vec3 turn = torque[i] / (0.4 * a.mass * a.radius * a.radius);
      a.half_velocity += in.dt * acceleration;
      a.half_spin += in.dt * turn;
      a.position += in.dt * a.half_velocity;
      a.velocity = a.half_velocity + in.velocity_lead * acceleration;
      a.spin = a.half_spin + in.velocity_lead * turn;
    }
  }

 private:
  struct Load {
    Vec3 force = Vec3::Zero(), turning = Vec3::Zero();  // turning: n x F_s
  };

  static double series(double a, double b) { return 2 * a * b / (a + b); }

  Load contact(const TwinSphere& a, const TwinSphere& b, std::pair<long, long> who, const Vec3& n, double overlap,
               const StepInput& in) {
    if (overlap <= 0) {
      springs_.erase(who);
      return {};
    }
    ++contacts_;
    const MaterialSpec &p = scene_.materials[a.material], &q = scene_.materials[b.material];
    const bool wall = b.mass == 0;
    const double k = series(p.normal_stiffness, q.normal_stiffness);
    const double e = std::sqrt(*p.restitution * *q.restitution);
    const double rate = in.growth.rate * (a.radius + b.radius) - (a.velocity - b.velocity).dot(n);
    double damping;
    if (scene_.contact.normal == NormalModel::hysteretic) {
      damping = hysteretic_damping(e) * k * overlap * (rate > 0 ? 1 : rate < 0 ? -1 : 0);
    } else {
      const double m = wall ? a.mass : a.mass * b.mass / (a.mass + b.mass);
      damping = 2 * linear_damping_ratio(e, scene_.contact.release) * std::sqrt(k * m) * rate;
    }
    double normal = k * overlap + damping;
    if (scene_.contact.normal == NormalModel::linear && scene_.contact.release == Release::zero_force && normal < 0) {
      damping = -k * overlap;
      normal = 0;
    }
    dissipated_ += damping * rate * in.dt;
    Load load;
    load.force = normal * n;
    if (!rotates(scene_)) return load;

    const double ks = series(*p.tangential_stiffness, *q.tangential_stiffness);
    const double mu = std::sqrt(p.friction * q.friction);
    const Vec3 at_contact =
        a.velocity - b.velocity - in.growth.scale * (a.radius * a.spin + b.radius * b.spin).cross(n);
    const Vec3 sliding = at_contact - at_contact.dot(n) * n;
    Vec3& s = springs_.try_emplace(who, Vec3::Zero()).first->second;
    const double length = s.norm();
    s -= s.dot(n) * n;
    if (s.norm() > 0) s *= length / s.norm();
    const Vec3 displacement = in.dt * sliding;
    s += displacement;
    const double limit = mu * std::abs(normal) / ks;
    if (s.norm() > limit) {
      const Vec3 kept = s * (limit / s.norm());
      dissipated_ += 0.5 * ks * (s.squaredNorm() - kept.squaredNorm()) - 0.5 * ks * (s - kept).dot(displacement);
      s = kept;
    }
    load.force -= ks * s;
    load.turning = n.cross(-ks * s);
    return load;
  }

  Scene scene_;
  Domain domain_;
  std::vector<Plane> planes_;
  std::vector<TwinSphere> spheres_;
  std::map<std::pair<long, long>, Vec3> springs_;
  int contacts_ = 0;
  double dissipated_ = 0;
};

}  // namespace packstone::engine::testing
