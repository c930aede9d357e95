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

/// Reads what contacts see of particles, one a lane, out of rows of numbers: position, radius, velocity and inverse
/// mass in eight, and the angular velocity in the first three of four others.
template <class PairLanes, class Number>
class RowReader {
 public:
  using Real = typename PairLanes::Real;

  RowReader(const void* rows, const void* spins)
      : rows_(static_cast<const Number*>(rows)), spins_(static_cast<const Number*>(spins)) {}

  /// Of PairLanes::width slots from this one on.
  template <bool turning>
  [[gnu::always_inline]] Bodies<PairLanes> bodies_in_line(std::int32_t slot) const {
    const Number* row = rows_ + std::size_t{row_length} * slot;
    Real low[4], high[4];
    PairLanes::template read_columns<4, row_length>(row, low);
    PairLanes::template read_columns<4, row_length>(row + velocity_at, high);
    Bodies<PairLanes> b{{low[0], low[1], low[2]}, low[3], {high[0], high[1], high[2]}, high[3], {}};
    if constexpr (turning) {
      PairLanes::template read_columns<3, spin_length>(spins_ + std::size_t{spin_length} * slot, low);
      b.angular_velocity = {low[0], low[1], low[2]};
    }
    return b;
  }

  /// One body beside itself.
  template <bool turning>
  Bodies<PairLanes> body_in_all_lanes(std::int32_t slot) const {
    std::uint32_t offset[PairLanes::width];
    std::fill_n(offset, PairLanes::width, row_length * static_cast<std::uint32_t>(slot));
    Bodies<PairLanes> body{};
    body.position = positions<4>(offset, body.radius);
    read_motion<false, turning>(body, offset, body);
    return body;
  }

  /// The rest of what contacts see of the neighbours, after their positions. Entries are read from memory once more:
  /// the compiler would rather keep their offsets, for which there are not enough registers.
  template <bool alike, bool turning>
  [[gnu::always_inline]] void read_motion(const Bodies<PairLanes>& self, const std::uint32_t* neighbour,
                                          Bodies<PairLanes>& other) const {
    asm("" : "+r"(neighbour));
    Real c[4];
    PairLanes::template read_columns<alike ? 3 : 4>(rows_ + velocity_at, neighbour, c);
    other.velocity = {c[0], c[1], c[2]};
    other.inverse_mass = alike ? self.inverse_mass : c[3];
    if constexpr (turning) {
      std::uint32_t offset[PairLanes::width];
      for (int lane = 0; lane < PairLanes::width; ++lane) offset[lane] = neighbour[lane] / spins_in_row;
      PairLanes::template read_columns<3>(spins_, offset, c);
      other.angular_velocity = {c[0], c[1], c[2]};
    }
  }

  [[gnu::always_inline]] void prefetch(std::uint32_t neighbour, bool turning) const {
    __builtin_prefetch(rows_ + neighbour);
    if (turning) __builtin_prefetch(spins_ + neighbour / spins_in_row);
  }

 protected:
  /// Radii are in the fourth column.
  template <int columns>
  [[gnu::always_inline]] simd::Vector<Real> positions(const std::uint32_t* neighbour, Real& radius) const {
    Real c[4];
    PairLanes::template read_columns<columns>(rows_, neighbour, c);
    if constexpr (columns > 3) radius = c[3];
    return {c[0], c[1], c[2]};
  }

 private:
  static constexpr std::uint32_t row_length = Row::doubles, velocity_at = Row::velocity_at, spin_length = Spin::doubles;
  static constexpr std::uint32_t spins_in_row = row_length / spin_length;
  static_assert(CompactRow::words == row_length && CompactRow::velocity_at == velocity_at);
  static_assert(CompactSpin::words == spin_length);

  const Number* rows_;
  const Number* spins_;
};

/// Forces between particles in the precision of their motion.
template <class LanesOfMotion>
class DoublePrecision : public RowReader<LanesOfMotion, double> {
 public:
  using Lanes = LanesOfMotion;      ///< of the motion
  using PairLanes = LanesOfMotion;  ///< of the forces between particles
  using Number = double;            ///< of the forces between particles
  using Real = typename PairLanes::Real;
  static constexpr bool compact = false;
  static constexpr int parts = 1;  ///< lanes of motion that make the lanes of forces

  DoublePrecision(const Particles& p, const Domain& domain)
      : RowReader<PairLanes, Number>(p.now.rows.data(), p.now.spins.data()) {
    for (int axis = 0; axis < 3; ++axis) {
      side_[axis] = domain.size()[axis];
      inverse_side_[axis] = domain.periodic[axis] ? 1 / side_[axis] : 0;
    }
  }

  /// From the neighbours to these bodies [m]; sets the neighbours' radii.
  template <bool alike>
  [[gnu::always_inline]] simd::Vector<Real> separation(const Bodies<PairLanes>& self, const std::uint32_t* neighbour,
                                                       bool images, Real& radius) const {
    constexpr int columns = alike ? 3 : 4;
    radius = self.radius;
    const simd::Vector<Real> there = this->template positions<columns>(neighbour, radius);
    const simd::Vector<Real> d = self.position - there;
    return images ? nearest_image(d) : d;
  }

  /// reach - d [m].
  [[gnu::always_inline]] static Real overlap(const Real& reach, const Real& squared_distance,
                                             const Real& inverse_distance) {
    return reach - squared_distance * inverse_distance;
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

  std::array<double, 3> side_, inverse_side_;  ///< the latter 0 along axes that are not periodic
};

/// Forces between particles in single precision, from positions in fixed point: their differences are exact and as near
/// to those of the double ones as a period / 2^32.
template <class LanesOfForces>
class MixedPrecision : public RowReader<LanesOfForces, float> {
 public:
  using Lanes = typename LanesOfForces::Whole;
  using PairLanes = LanesOfForces;
  using Number = float;
  using Real = typename PairLanes::Real;
  static constexpr bool compact = true;
  static constexpr int parts = PairLanes::width / Lanes::width;

  MixedPrecision(const Particles& p, const Domain& /*domain*/)
      : RowReader<PairLanes, Number>(p.now.compact_rows.data(), p.now.compact_spins.data()), metres_(p.places.metres) {}

  /// The bodies' positions are bits of places.
  template <bool /*alike*/>
  [[gnu::always_inline]] simd::Vector<Real> separation(const Bodies<PairLanes>& self, const std::uint32_t* neighbour,
                                                       bool /*images*/, Real& radius) const {
    const simd::Vector<Real>& here = self.position;
    const simd::Vector<Real> there = this->template positions<4>(neighbour, radius);
    const auto along = [&](const Real& a, const Real& b, int axis) __attribute__((always_inline)) {
      return Real(metres_[axis]) * PairLanes::difference_of_places(a, b);
    };
    return {along(here.x, there.x, 0), along(here.y, there.y, 1), along(here.z, there.z, 2)};
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

 private:
  Vec3 metres_;
};

}  // namespace packstone::engine
