// Newton's equations, Zhong et al., Acta Phys. Sin. 58 (2009), eqs [1], [2], by the leapfrog scheme:
//   v(n+1/2) = v(n-1/2) + dt a(n),   x(n+1) = x(n) + dt v(n+1/2).
// Contacts of the next instant see v(n+1/2) + lead a(n): with a lead of dt/2 an estimate of v(n+1) of second order,
// with none the lagging half-step velocity (ContactVelocity; docs/physics.md).
#pragma once

#include <algorithm>

#include "engine/detection/neighbour_list.hpp"
#include "engine/dynamics/contact_forces.hpp"
#include "engine/dynamics/lane_sums.hpp"
#include "engine/dynamics/particles.hpp"
#include "engine/dynamics/step.hpp"

namespace packstone::engine {

/// Where some particles sit side by side, one a lane.
struct Seats {
  std::int32_t slot;    ///< of the first
  std::uint32_t lanes;  ///< bits of those that hold a particle

  template <class Lanes>
  static constexpr std::uint32_t all = (1u << Lanes::width) - 1;
};

/// Lanes of motion of a group, or of one part of it.
template <class Lanes>
Seats seats_of(const NeighbourGroup& group, int part) {
  return {group.slot + part * Lanes::width, group.lanes >> (part * Lanes::width) & Seats::all<Lanes>};
}

/// Writes the compact rows of the next instant.
template <class L>
[[gnu::always_inline]] inline void write_compact(Particles& p, std::int32_t slot,
                                                 const simd::Vector<typename L::Real>& position,
                                                 const simd::Vector<typename L::Real>& velocity,
                                                 const Bodies<L>& self) {
  using simd::fused;
  using Real = typename L::Real;
  const auto place = [&](const Real& x, int axis) {
    return L::low_word(fused(x, Real(p.places.per_metre[axis]), Real(p.places.integer_in_low_word[axis])));
  };
  const typename L::Word low[4] = {place(position.x, 0), place(position.y, 1), place(position.z, 2),
                                   L::narrowed(self.radius)};
  const typename L::Word high[4] = {L::narrowed(velocity.x), L::narrowed(velocity.y), L::narrowed(velocity.z),
                                    L::narrowed(self.inverse_mass)};
  auto* row = reinterpret_cast<float*>(&p.next.compact_rows[slot]);
  L::template write_words<CompactRow::words>(row, low);
  L::template write_words<CompactRow::words>(row + CompactRow::velocity_at, high);
}

/// Moves particles from instant n to n+1, and tells sums how far they are from where the list was built.
template <bool record, bool turning, bool compact, class L>
[[gnu::always_inline]] inline void move(Particles& p, const NeighbourList& list, const Seats& seats,
                                        const Bodies<L>& self, const Loads<L>& loads, typename L::Mask occupied,
                                        const StepInput& in, Recorder* recorder, LaneSums<L>& sums) {
  using simd::larger;
  using Real = typename L::Real;
  using Vector = simd::Vector<Real>;
  const auto load = [&](const VectorArray& v) {
    return Vector{L::load(&v.x[seats.slot]), L::load(&v.y[seats.slot]), L::load(&v.z[seats.slot])};
  };
  const auto store = [&](VectorArray& to, const Vector& v) {
    L::store(&to.x[seats.slot], v.x);
    L::store(&to.y[seats.slot], v.y);
    L::store(&to.z[seats.slot], v.z);
  };
  const Real dt(in.dt);
  const Vector gravity{Real(in.gravity[0]), Real(in.gravity[1]), Real(in.gravity[2])};
  const bool leads = !p.half_velocity.empty();  // else the rows hold the half step's velocities
  const Vector before = leads ? load(p.half_velocity) : self.velocity;
  const Vector acceleration = fused(self.inverse_mass, loads.force, gravity);
  const Vector half = fused(dt, acceleration, before);
  const Vector position = fused(dt, half, self.position);
  const Vector velocity = leads ? fused(Real(in.velocity_lead), acceleration, half) : half;
  if (leads) store(p.half_velocity, half);
  double* row = reinterpret_cast<double*>(&p.next.rows[seats.slot]);
  const Real low[4] = {position.x, position.y, position.z, self.radius};
  const Real high[4] = {velocity.x, velocity.y, velocity.z, self.inverse_mass};
  L::template write_columns<Row::doubles>(row, low);
  L::template write_columns<Row::doubles>(row + Row::velocity_at, high);
  if constexpr (compact) write_compact(p, seats.slot, position, velocity, self);

  const Real mass = L::load(&p.mass[seats.slot]);
  sums.momentum = fused(mass, half, sums.momentum);
  const Vector moved = position - load(list.reference());
  sums.displacement += only(occupied, moved);
  const Vec3 common = list.expected_displacement();
  const Vector deviation = moved - Vector{Real(common[0]), Real(common[1]), Real(common[2])};
  const Real share = squared_length(deviation) * L::load(&list.inverse_margin_squared()[seats.slot]);
  sums.largest_share_squared = larger(sums.largest_share_squared, share);
  sums.within_margins = sums.within_margins & (share < Real(1.0));

  [[maybe_unused]] Vector half_turn_before = Vector::zero(), angular_acceleration = Vector::zero();
  if constexpr (turning) {
    half_turn_before = leads ? load(p.half_angular_velocity) : self.angular_velocity;
    angular_acceleration = L::load(&p.inverse_inertia[seats.slot]) * loads.torque;
    const Vector half_turn = fused(dt, angular_acceleration, half_turn_before);
    if (leads) store(p.half_angular_velocity, half_turn);
    const Vector turn = leads ? fused(Real(in.velocity_lead), angular_acceleration, half_turn) : half_turn;
    const Real spin[4] = {turn.x, turn.y, turn.z, Real(0.0)};
    L::template write_columns<Spin::doubles>(reinterpret_cast<double*>(&p.next.spins[seats.slot]), spin);
    if constexpr (compact) {
      const typename L::Word words[4] = {L::narrowed(turn.x), L::narrowed(turn.y), L::narrowed(turn.z),
                                         L::narrowed(Real(0.0))};
      L::template write_words<CompactSpin::words>(reinterpret_cast<float*>(&p.next.compact_spins[seats.slot]), words);
    }
  }
  if constexpr (record) {
    for (int k = 0; k < L::width; ++k) {
      const std::size_t slot = static_cast<std::size_t>(seats.slot) + k;
      if ((seats.lanes >> k & 1u) == 0) continue;
      const Vec3 a = lane_of<L>(acceleration, k), v = lane_of<L>(before, k) + 0.5 * in.dt * a;
      sums.recorded.kinetic_translational += 0.5 * p.mass[slot] * v.squaredNorm();
      sums.recorded.largest_speed_squared = std::max(sums.recorded.largest_speed_squared, v.squaredNorm());
      recorder->velocity[p.id[slot]] = v;
      recorder->force[p.id[slot]] = p.mass[slot] * a;
      if constexpr (turning) {
        const Vec3 turn = lane_of<L>(half_turn_before, k) + 0.5 * in.dt * lane_of<L>(angular_acceleration, k);
        sums.recorded.kinetic_rotational += 0.5 / p.inverse_inertia[slot] * turn.squaredNorm();
        recorder->angular_velocity[p.id[slot]] = turn;
        if (!recorder->angular_acceleration.empty()) {
          recorder->angular_acceleration[p.id[slot]] = lane_of<L>(angular_acceleration, k);
        }
      }
    }
  }
}

}  // namespace packstone::engine
