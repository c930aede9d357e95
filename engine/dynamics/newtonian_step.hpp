// Newton's equations, Zhong et al., Acta Phys. Sin. 58 (2009), eqs [1], [2], by the leapfrog scheme:
//   v(n+1/2) = v(n-1/2) + dt a(n),   x(n+1) = x(n) + dt v(n+1/2).
// Forces that depend on velocity see v(n) = v(n-1/2) + dt/2 a(n-1), of second order, rather than the lagging half-step
// velocity, which feeds energy into contacts with friction.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/contact/pair_table.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/threads.hpp"

namespace packstone::engine {

template <class Normal, class Tangential>
class NewtonianStep final : public Dynamics {
 public:
  NewtonianStep(const Scene& scene, const Domain& domain, const std::vector<Plane>& planes, double largest_radius)
      : planes_(planes), list_(domain, largest_radius), normal_(scene.materials), tangential_(scene.materials) {}

  const NeighbourList& neighbours() const override { return list_; }

  void rebuild(Particles& particles, const Growth& growth) override {
    if constexpr (Tangential::active) {
      const NeighbourList before = list_;
      list_.build(particles, growth);
      carry_springs(before, particles.size());
    } else {
      list_.build(particles, growth);
    }
  }

  StepSums advance(Particles& particles, const StepInput& input, Recorder* recorder) override {
    const auto blocks = static_cast<std::ptrdiff_t>((particles.size() + particles_per_block - 1) / particles_per_block);
    std::vector<Block> results(blocks);
#pragma omp parallel for schedule(static) num_threads(useful_threads(particles.size()))
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      const std::size_t begin = b * particles_per_block, end = std::min(begin + particles_per_block, particles.size());
      for (std::size_t i = begin; i < end; ++i) {
        recorder ? advance_particle<true>(particles, i, input, recorder, results[b])
                 : advance_particle<false>(particles, i, input, recorder, results[b]);
      }
    }
    // Blocks are added in order, so that the sums have the same bits for any number of threads.
    StepSums sums;
    for (const Block& block : results) {
      sums.add(block.sums);
      if (recorder && recorder->want_contacts) append(recorder->contacts, block.contacts);
    }
    return sums;
  }

 private:
  struct Block {
    StepSums sums;
    Contacts contacts;
  };

  /// One side of a contact.
  struct Body {
    Vec3 velocity = Vec3::Zero();
    Vec3 angular_velocity = Vec3::Zero();
    double radius = 0;        ///< at full size; 0 for a wall [m]
    double inverse_mass = 0;  ///< 0 for a wall [1/kg]
    std::size_t material = 0;
  };

  struct Load {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
  };

  /// Where a contact is and whom it joins.
  struct Place {
    Vec3 normal;  ///< from the second body to the first
    double overlap;
    std::int64_t first, second;  ///< ids, -1-k for boundary k
    Vec3 first_position;
    double share;  ///< of its energies to count here: both particles of a pair see it
  };

  static Body body(const Particles& p, std::size_t i) {
    Body b{p.now.velocity.get(i), Vec3::Zero(), p.radius[i], p.inverse_mass[i], p.material[i]};
    if constexpr (Tangential::active) b.angular_velocity = p.now.angular_velocity.get(i);
    return b;
  }

  template <bool record>
  void advance_particle(Particles& p, std::size_t i, const StepInput& in, Recorder* recorder, Block& out) {
    const Vec3 here = p.now.position.get(i);
    const Body self = body(p, i);
    Load load;
    for (std::size_t k = list_.first(i); k < list_.last(i); ++k) {
      const Neighbour& neighbour = list_.entry(k);
      const auto j = static_cast<std::size_t>(neighbour.index);
      const Vec3 d = (here - p.now.position.get(j)) - list_.shift(neighbour.image);
      const double reach = in.growth.scale * (self.radius + p.radius[j]);
      const double squared = d.squaredNorm();
      if (squared >= reach * reach) {
        if constexpr (Tangential::active) springs_[k].setZero();
        continue;
      }
      const double distance = std::sqrt(squared);
      const Place place{d / distance, reach - distance, static_cast<std::int64_t>(i), neighbour.index, here, 0.5};
      touch<record>(self, body(p, j), place, spring(springs_, k), in, recorder, load, out);
    }
    for (std::size_t w = 0; w < planes_.size(); ++w) {
      const double overlap = in.growth.scale * self.radius - planes_[w].distance(here);
      if (overlap <= 0) {
        if constexpr (Tangential::active) wall_springs_[i * planes_.size() + w].setZero();
        continue;
      }
      Body wall;
      wall.material = planes_[w].material;
      const Place place{
          planes_[w].normal, overlap, static_cast<std::int64_t>(i), -1 - static_cast<std::int64_t>(w), here, 1.0};
      touch<record>(self, wall, place, spring(wall_springs_, i * planes_.size() + w), in, recorder, load, out);
    }
    move<record>(p, i, load, in, recorder, out.sums);
  }

  static Vec3* spring(std::vector<Vec3>& springs, std::size_t k) {
    if constexpr (Tangential::active) {
      return &springs[k];
    } else {
      return nullptr;
    }
  }

  /// Adds one contact's force and torque on the first body.
  template <bool record>
  [[gnu::always_inline]] void touch(const Body& first, const Body& second, const Place& at, Vec3* spring,
                                    const StepInput& in, Recorder* recorder, Load& load, Block& out) const {
    const Vec3 relative = first.velocity - second.velocity;
    const double growth_rate = in.growth.rate * (first.radius + second.radius);
    const double rate = growth_rate - relative.dot(at.normal);
    const auto& law = normal_(first.material, second.material);
    const NormalForce normal = Normal::force(law, at.overlap, rate, first.inverse_mass + second.inverse_mass);
    Vec3 force = normal.total() * at.normal;
    double dissipated = normal.damping * rate * in.dt;
    double elastic = Normal::energy(law, at.overlap);
    bool sliding = false;
    if constexpr (Tangential::active) {
      // Lever arms at the instant's radii; the sum has the same bits seen from either body.
      const Vec3 spin =
          in.growth.scale * (first.radius * first.angular_velocity + second.radius * second.angular_velocity);
      const Vec3 contact_velocity = relative - spin.cross(at.normal);
      const Vec3 sliding_velocity = contact_velocity - contact_velocity.dot(at.normal) * at.normal;
      const auto& friction = tangential_(first.material, second.material);
      const auto tangential =
          Tangential::advance(friction, *spring, at.normal, sliding_velocity, normal.total(), in.dt);
      force += tangential.force;
      load.torque -= in.growth.scale * first.radius * at.normal.cross(tangential.force);
      dissipated += tangential.dissipated;
      elastic += tangential.elastic;
      sliding = tangential.sliding;
    }
    load.force += force;

    StepSums& sums = out.sums;
    sums.dissipated += at.share * dissipated;
    sums.growth_work += at.share * normal.total() * growth_rate * in.dt;
    if (at.overlap > in.overlap_limit * first.radius && !sums.offence) {
      sums.offence = Offence{at.first, at.second, at.overlap};
    }
    if constexpr (record) {
      const bool wall = at.second < 0;
      sums.elastic += at.share * elastic;
      sums.largest_overlap_share = std::max(sums.largest_overlap_share, at.overlap / first.radius);
      if (!wall && at.second < at.first) return;
      ++(wall ? sums.wall_contacts : sums.particle_contacts);
      if (!recorder->want_contacts) return;
      Contacts& c = out.contacts;
      c.first.push_back(at.first);
      c.second.push_back(at.second);
      c.force.push_back(force);
      c.normal.push_back(at.normal);
      c.overlap.push_back(at.overlap);
      c.point.push_back(at.first_position - (in.growth.scale * first.radius - 0.5 * at.overlap) * at.normal);
      c.sliding.push_back(sliding);
    }
  }

  template <bool record>
  [[gnu::always_inline]] void move(Particles& p, std::size_t i, const Load& load, const StepInput& in,
                                   Recorder* recorder, StepSums& sums) const {
    const Vec3 before = p.half_velocity.get(i);
    const Vec3 acceleration = p.inverse_mass[i] * load.force + in.gravity;
    const Vec3 half = before + in.dt * acceleration;
    const Vec3 position = p.now.position.get(i) + in.dt * half;
    p.half_velocity.set(i, half);
    p.next.position.set(i, position);
    p.next.velocity.set(i, half + 0.5 * in.dt * acceleration);
    const double mass = 1 / p.inverse_mass[i];
    sums.gravity_work += mass * in.dt * in.gravity.dot(half);
    const double displacement = (position - list_.reference().get(i)).squaredNorm();
    sums.largest_displacement_squared =
        std::max(sums.largest_displacement_squared, displacement < std::numeric_limits<double>::infinity()
                                                        ? displacement
                                                        : std::numeric_limits<double>::infinity());
    [[maybe_unused]] Vec3 half_turn_before = Vec3::Zero(), angular_acceleration = Vec3::Zero();
    if constexpr (Tangential::active) {
      half_turn_before = p.half_angular_velocity.get(i);
      angular_acceleration = p.inverse_inertia[i] * load.torque;
      const Vec3 half_turn = half_turn_before + in.dt * angular_acceleration;
      p.half_angular_velocity.set(i, half_turn);
      p.next.angular_velocity.set(i, half_turn + 0.5 * in.dt * angular_acceleration);
    }
    if constexpr (record) {
      const Vec3 velocity = before + 0.5 * in.dt * acceleration;
      sums.kinetic_translational += 0.5 * mass * velocity.squaredNorm();
      sums.largest_speed_squared = std::max(sums.largest_speed_squared, velocity.squaredNorm());
      recorder->velocity[i] = velocity;
      recorder->force[i] = mass * acceleration;
      if constexpr (Tangential::active) {
        const Vec3 turn = half_turn_before + 0.5 * in.dt * angular_acceleration;
        sums.kinetic_rotational += 0.5 / p.inverse_inertia[i] * turn.squaredNorm();
        recorder->angular_velocity[i] = turn;
      }
    }
  }

  static void append(Contacts& to, const Contacts& from) {
    const auto extend = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
    extend(to.first, from.first);
    extend(to.second, from.second);
    extend(to.force, from.force);
    extend(to.normal, from.normal);
    extend(to.overlap, from.overlap);
    extend(to.point, from.point);
    extend(to.sliding, from.sliding);
  }

  void carry_springs(const NeighbourList& before, std::size_t count) {
    std::vector<Vec3> carried(list_.size(), Vec3::Zero());
    if (before.builds() == 0) {
      wall_springs_.assign(count * planes_.size(), Vec3::Zero());
    } else {
      const auto n = static_cast<std::ptrdiff_t>(count);
#pragma omp parallel for schedule(static) num_threads(useful_threads(count))
      for (std::ptrdiff_t i = 0; i < n; ++i) {
        for (std::size_t k = list_.first(i); k < list_.last(i); ++k) {
          for (std::size_t old = before.first(i); old < before.last(i); ++old) {
            if (before.entry(old).index == list_.entry(k).index) carried[k] = springs_[old];
          }
        }
      }
    }
    springs_ = std::move(carried);
  }

  std::vector<Plane> planes_;
  NeighbourList list_;
  PairTable<Normal> normal_;
  PairTable<Tangential> tangential_;
  std::vector<Vec3> springs_;       ///< one an entry of the list [m]; unused without friction
  std::vector<Vec3> wall_springs_;  ///< one a particle and plane
};

}  // namespace packstone::engine
