// The step as one would write it for reading: every pair of particles, one after the other, plain vectors. The fast
// step is checked against it.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/domain.hpp"
#include "core/scene.hpp"
#include "core/vec3.hpp"
#include "engine/contact/collision.hpp"
#include "engine/contact/mixing.hpp"
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
      : scene_(scene), domain_(scene.box()), spheres_(std::move(spheres)) {}

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
      for (std::size_t w = 0; w < scene_.boundaries.size(); ++w) {  // planes at rest
        const BoundarySpec& plane = scene_.boundaries[w];
        const Vec3 normal = plane.normal->normalized();
        TwinSphere wall{};
        wall.velocity = wall.spin = Vec3::Zero();
        wall.material = scene_.material_index(plane.material);
        const double overlap = in.growth.scale * a.radius - normal.dot(a.position - *plane.point);
        const Load on_a = contact(a, wall, {long(i), -1 - long(w)}, normal, overlap, in);
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

  /// Laws that are written out here.
  bool knows_laws() const {
    const ContactSpec& c = scene_.contact;
    return (c.normal == NormalModel::linear || (c.normal == NormalModel::hysteretic && c.sign_speed == 0)) &&
           (!rotates(scene_) || c.tangential == TangentialModel::cundall_strack) && !c.van_der_waals.present;
  }

  Load contact(const TwinSphere& a, const TwinSphere& b, std::pair<long, long> who, const Vec3& n, double overlap,
               const StepInput& in) {
    if (overlap <= 0) {
      springs_.erase(who);
      kept_.erase(who);
    }
    if (!knows_laws()) return contact_by_laws(a, b, who, n, overlap, in);
    if (overlap <= 0) return {};
    ++contacts_;
    const MaterialSpec &p = scene_.materials[a.material], &q = scene_.materials[b.material];
    const bool wall = b.mass == 0;
    const double k = series(*p.normal_stiffness, *q.normal_stiffness);
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
    const Vec3 sliding = sliding_velocity(a, b, n, overlap, in);
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

  /// In the contact plane; velocities that lag half a step behind turn with the normal of then.
  static Vec3 sliding_velocity(const TwinSphere& a, const TwinSphere& b, const Vec3& n, double overlap,
                               const StepInput& in) {
    const Vec3 relative = a.velocity - b.velocity;
    const bool wall = b.mass == 0;
    const double distance = in.growth.scale * (a.radius + b.radius) - overlap;
    const Vec3 turning = wall ? Vec3(Vec3::Zero()) : Vec3((relative - relative.dot(n) * n) / distance);
    const Vec3 normal_then = n - in.velocity_lag() * turning;
    const Vec3 at_contact = relative - in.growth.scale * (a.radius * a.spin + b.radius * b.spin).cross(normal_then);
    return at_contact - at_contact.dot(n) * n;
  }

  /// The engine's laws, one number at a time: other tests hold them against references; here it is their way through
  /// lanes, tables of pairs, history and walls.
  Load contact_by_laws(const TwinSphere& a, const TwinSphere& b, std::pair<long, long> who, const Vec3& n,
                       double overlap, const StepInput& in) {
    const ContactSpec& laws = scene_.contact;
    if (overlap <= -laws.van_der_waals.range()) return {};
    const bool wall = b.mass == 0;
    const PairSize<double> size{1 / a.mass + (wall ? 0 : 1 / b.mass),
                                wall ? a.radius : a.radius * b.radius / (a.radius + b.radius)};
    Load load;
    if (laws.van_der_waals.present)
      load.force -= VanDerWaals(laws.van_der_waals).force(size.effective_radius, -overlap) * n;
    if (overlap <= 0) return load;
    ++contacts_;
    const MaterialSpec &p = scene_.materials[a.material], &q = scene_.materials[b.material];
    Kept& kept = kept_[who];
    ChosenNormal::Parameters<double> normal_pair{};
    set_pair(normal_pair, laws, p, q);
    const double rate = in.growth.rate * (a.radius + b.radius) - (a.velocity - b.velocity).dot(n);
    const NormalForce<double> normal =
        ChosenNormal(laws).force(ChosenNormal::coefficients(normal_pair, size), overlap, rate, kept.by_normal);
    dissipated_ += normal.damping * rate * in.dt + normal.loss;
    load.force += normal.total() * n;
    if (!rotates(scene_)) return load;
    const Vec3 v = sliding_velocity(a, b, n, overlap, in);
    const simd::Vector<double> direction{n[0], n[1], n[2]}, velocity{v[0], v[1], v[2]};
    ChosenTangential::Parameters<double> tangential_pair{};
    set_pair(tangential_pair, laws, p, q);
    const double total = normal.total();
    const auto friction =
        ChosenTangential(laws).advance(ChosenTangential::coefficients(tangential_pair, size),
                                       Slip<double>{direction, velocity, total, overlap, in.dt}, kept.by_tangential);
    dissipated_ += friction.dissipated;
    const Vec3 force(friction.force.x, friction.force.y, friction.force.z);
    load.force += force;
    load.turning = n.cross(force);
    return load;
  }

  struct Kept {
    std::array<double, ChosenNormal::most_kept> by_normal{};
    std::array<double, ChosenTangential::most_kept> by_tangential{};
  };

  Scene scene_;
  Domain domain_;
  std::vector<TwinSphere> spheres_;
  std::map<std::pair<long, long>, Vec3> springs_;
  std::map<std::pair<long, long>, Kept> kept_;
  int contacts_ = 0;
  double dissipated_ = 0;
};

}  // namespace packstone::engine::testing
