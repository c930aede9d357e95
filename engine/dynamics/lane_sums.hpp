// What a block of groups adds up on its way, lane by lane, until its end.
#pragma once

#include <algorithm>
#include <limits>

#include "engine/dynamics/step.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// What one block of groups gives to the step.
struct BlockResult {
  StepSums sums;
  Vec3 displacement = Vec3::Zero();  ///< of all its particles since the list was built [m]
  Contacts contacts;
};

template <class Lanes>
struct LaneSums {
  using Real = typename Lanes::Real;
  using Vector = simd::Vector<Real>;

  Real damping_power = 0.0;             ///< [W]
  Real sliding_loss = 0.0;              ///< [J]
  Real growth_power = 0.0;              ///< [W]
  Vector momentum = Vector::zero();     ///< half a step on [kg m/s]
  Vector displacement = Vector::zero();  ///< [m]
  Real largest_share_squared = 0.0;     ///< of a margin used up
  typename Lanes::Mask within_margins = Lanes::mask((1u << Lanes::width) - 1);  ///< false as well for what is not a number
  Real elastic = 0.0;                   ///< recorded [J]
  StepSums recorded;

  void add_to(BlockResult& result, const StepInput& in) const {
    using simd::bits, simd::largest, simd::sum;
    StepSums& s = result.sums;
    s.dissipated += in.dt * sum(damping_power) + sum(sliding_loss);
    s.growth_work += in.dt * sum(growth_power);
    s.gravity_work += in.dt * in.gravity.dot(total(momentum));
    s.elastic += sum(elastic);
    const bool within = bits(within_margins) == (1u << Lanes::width) - 1;
    const double share = within ? largest(largest_share_squared) : std::numeric_limits<double>::infinity();
    s.largest_share_squared = std::max(s.largest_share_squared, share);
    s.add(recorded);
    result.displacement += total(displacement);
  }

 private:
  static Vec3 total(const Vector& v) {
    using simd::sum;
    return {sum(v.x), sum(v.y), sum(v.z)};
  }
};

}  // namespace packstone::engine
