// How contacts see the particles: in double precision the rows themselves, in mixed precision compact copies of half
// the size, for twice as many lanes. Motion is in double precision either way.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/domain.hpp"
#include "engine/dynamics/contact_forces.hpp"
#include "engine/dynamics/particles.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// The same entries, to be read from memory once more: the compiler would rather keep their offsets, for which there
/// are not enough registers.
[[gnu::always_inline]] inline const std::uint32_t* read_again(const std::uint32_t* entries) {
  asm("" : "+r"(entries));
  return entries;
}

/// One body beside itself in every lane.
template <bool turning, class Precision>
Bodies<typename Precision::PairLanes> in_all_lanes(const Precision& seen, std::int32_t slot) {
  using PairLanes = typename Precision::PairLanes;
  std::uint32_t offset[PairLanes::width];
  std::fill_n(offset, PairLanes::width, Row::doubles * static_cast<std::uint32_t>(slot));
  Bodies<PairLanes> body{};
  body.position = seen.template positions<4>(offset, body.radius);
  seen.template read_motion<false, turning>(body, offset, body);
  return body;
}

/// Forces between particles in the precision of their motion.
template <class LanesOfMotion>
class DoublePrecision {
 public:
  using Lanes = LanesOfMotion;      ///< of the motion
  using PairLanes = LanesOfMotion;  ///< of the forces between particles
  using Number = double;            ///< of the forces between particles
  using Real = typename PairLanes::Real;
  static constexpr bool compact = false;
  static constexpr int parts = 1;  ///< lanes of motion that make the lanes of forces

  DoublePrecision(const Particles& p, const Domain& domain)
      : rows_(reinterpret_cast<const double*>(p.now.rows.data())),
        spins_(reinterpret_cast<const double*>(p.now.spins.data())) {
    for (int axis = 0; axis < 3; ++axis) {
      side_[axis] = domain.size()[axis];
      inverse_side_[axis] = domain.periodic[axis] ? 1 / side_[axis] : 0;
    }
  }

  template <bool turning>
  [[gnu::always_inline]] Bodies<PairLanes> bodies_in_line(std::int32_t slot) const {
    Real c[8];
    PairLanes::template read_columns<8, Row::doubles>(rows_ + std::size_t{Row::doubles} * slot, c);
    Bodies<PairLanes> b{{c[0], c[1], c[2]}, c[3], {c[4], c[5], c[6]}, c[7], {}};
    if constexpr (turning) {
      PairLanes::template read_columns<3, Spin::doubles>(spins_ + std::size_t{Spin::doubles} * slot, c);
      b.angular_velocity = {c[0], c[1], c[2]};
    }
    return b;
  }

  template <bool turning>
  Bodies<PairLanes> body_in_all_lanes(std::int32_t slot) const {
    return in_all_lanes<turning>(*this, slot);
  }

  /// From the neighbours to these bodies [m]; sets the neighbours' radii.
  template <bool alike>
  [[gnu::always_inline]] simd::Vector<Real> separation(const Bodies<PairLanes>& self, const std::uint32_t* neighbour,
                                                       bool images, Real& radius) const {
    constexpr int columns = alike ? 3 : 4;
    radius = self.radius;
    const simd::Vector<Real> there = positions<columns>(neighbour, radius);
    const simd::Vector<Real> d = self.position - there;
    return images ? nearest_image(d) : d;
  }
  /// Radii are in the fourth column.
  template <int columns>
  [[gnu::always_inline]] simd::Vector<Real> positions(const std::uint32_t* neighbour, Real& radius) const {
    Real c[4];
    PairLanes::template read_columns<columns>(rows_, neighbour, c);
    if constexpr (columns > 3) radius = c[3];
    return {c[0], c[1], c[2]};
  }

  /// The rest of what contacts see of the neighbours.
  template <bool alike, bool turning>
  [[gnu::always_inline]] void read_motion(const Bodies<PairLanes>& self, const std::uint32_t* neighbour,
                                          Bodies<PairLanes>& other) const {
    Real c[4];
    PairLanes::template read_columns<alike ? 3 : 4>(rows_ + Row::velocity_at, neighbour, c);
    other.velocity = {c[0], c[1], c[2]};
    other.inverse_mass = alike ? self.inverse_mass : c[3];
    if constexpr (turning) {
      static_assert(Row::doubles == 2 * Spin::doubles);
      std::uint32_t offset[PairLanes::width];
      for (int lane = 0; lane < PairLanes::width; ++lane) offset[lane] = neighbour[lane] / 2;
      PairLanes::template read_columns<3>(spins_, offset, c);
      other.angular_velocity = {c[0], c[1], c[2]};
    }
  }

  /// reach - d [m].
  [[gnu::always_inline]] static Real overlap(const Real& reach, const Real& squared_distance,
                                             const Real& inverse_distance) {
    return reach - squared_distance * inverse_distance;
  }

  [[gnu::always_inline]] void prefetch(std::uint32_t neighbour, bool turning) const {
    __builtin_prefetch(rows_ + neighbour);
    if (turning) __builtin_prefetch(spins_ + neighbour / 2);
  }

 private:
  /// d less the box's sides that it is nearest to; unchanged along axes that are not periodic.
  [[gnu::always_inline]] simd::Vector<Real> nearest_image(const simd::Vector<Real>& d) const {
    using simd::fused, simd::nearest_integer;
    const auto along = [&](const Real& x, int axis) {
      return fused(-nearest_integer(x * Real(inverse_side_[axis])), Real(side_[axis]), x);
    };
    return {along(d.x, 0), along(d.y, 1), along(d.z, 2)};
  }

  const double* rows_;
  const double* spins_;
  std::array<double, 3> side_, inverse_side_;  ///< the latter 0 along axes that are not periodic
};

/// Forces between particles in single precision, from positions in fixed point: their differences are exact and as near
/// to those of the double ones as a period / 2^32.
template <class LanesOfForces>
class MixedPrecision {
 public:
  using Lanes = typename LanesOfForces::Whole;
  using PairLanes = LanesOfForces;
  using Number = float;
  using Real = typename PairLanes::Real;
  static constexpr bool compact = true;
  static constexpr int parts = PairLanes::width / Lanes::width;

  MixedPrecision(const Particles& p, const Domain& /*domain*/)
      : rows_(reinterpret_cast<const float*>(p.now.compact_rows.data())),
        spins_(reinterpret_cast<const float*>(p.now.compact_spins.data())),
        metres_(p.places.metres) {}

  /// Positions are bits of places, which separation understands.
  template <bool turning>
  [[gnu::always_inline]] Bodies<PairLanes> bodies_in_line(std::int32_t slot) const {
    const float* row = rows_ + std::size_t{CompactRow::words} * slot;
    Real low[4], high[4];
    PairLanes::template read_columns<4, CompactRow::words>(row, low);
    PairLanes::template read_columns<4, CompactRow::words>(row + CompactRow::velocity_at, high);
    Bodies<PairLanes> b{{low[0], low[1], low[2]}, low[3], {high[0], high[1], high[2]}, high[3], {}};
    if constexpr (turning) {
      PairLanes::template read_columns<3, CompactSpin::words>(spins_ + std::size_t{CompactSpin::words} * slot, low);
      b.angular_velocity = {low[0], low[1], low[2]};
    }
    return b;
  }

  template <bool turning>
  Bodies<PairLanes> body_in_all_lanes(std::int32_t slot) const {
    return in_all_lanes<turning>(*this, slot);
  }

  template <bool /*alike*/>
  [[gnu::always_inline]] simd::Vector<Real> separation(const Bodies<PairLanes>& self, const std::uint32_t* neighbour,
                                                       bool /*images*/, Real& radius) const {
    const simd::Vector<Real>& here = self.position;
    const simd::Vector<Real> there = positions<4>(neighbour, radius);
    const auto along = [&](const Real& a, const Real& b, int axis) __attribute__((always_inline)) {
      return Real(metres_[axis]) * PairLanes::difference_of_places(a, b);
    };
    return {along(here.x, there.x, 0), along(here.y, there.y, 1), along(here.z, there.z, 2)};
  }
  template <int columns>
  [[gnu::always_inline]] simd::Vector<Real> positions(const std::uint32_t* neighbour, Real& radius) const {
    Real c[4];
    PairLanes::template read_columns<columns>(rows_, neighbour, c);
    if constexpr (columns > 3) radius = c[3];
    return {c[0], c[1], c[2]};
  }

  template <bool alike, bool turning>
  [[gnu::always_inline]] void read_motion(const Bodies<PairLanes>& self, const std::uint32_t* neighbour,
                                          Bodies<PairLanes>& other) const {
    Real c[4];
    neighbour = read_again(neighbour);
    PairLanes::template read_columns<alike ? 3 : 4>(rows_ + CompactRow::velocity_at, neighbour, c);
    other.velocity = {c[0], c[1], c[2]};
    other.inverse_mass = alike ? self.inverse_mass : c[3];
    if constexpr (turning) {
      static_assert(CompactRow::words == 2 * CompactSpin::words);
      std::uint32_t offset[PairLanes::width];
      for (int lane = 0; lane < PairLanes::width; ++lane) offset[lane] = neighbour[lane] / 2;
      PairLanes::template read_columns<3>(spins_, offset, c);
      other.angular_velocity = {c[0], c[1], c[2]};
    }
  }

  /// reach - d as (reach^2 - d^2) / (reach + d), which rounds 1.6 times less [m].
  [[gnu::always_inline]] static Real overlap(const Real& reach, const Real& squared_distance,
                                             const Real& inverse_distance) {
    using simd::fused, simd::rough_reciprocal;
    const Real sum = fused(squared_distance, inverse_distance, reach);
    const Real rough = rough_reciprocal(sum);
    const Real reciprocal = fused(fused(-sum, rough, Real(1.0)), rough, rough);
    return fused(reach, reach, -squared_distance) * reciprocal;
  }

  [[gnu::always_inline]] void prefetch(std::uint32_t neighbour, bool turning) const {
    __builtin_prefetch(rows_ + neighbour);
    if (turning) __builtin_prefetch(spins_ + neighbour / 2);
  }

 private:
  const float* rows_;
  const float* spins_;
  Vec3 metres_;
};

}  // namespace packstone::engine
