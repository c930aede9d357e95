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

/// Which of the sums below contacts of given laws add to at all.
struct SumsInUse {
  bool plastic, growth, sliding, recorded;
};

/// Over the contacts of one kind.
template <class Real>
struct ContactSums {
  Real damping_power = 0.0;                                 ///< [W]
  Real plastic_loss = 0.0;                                  ///< [J]
  Real growth_power = 0.0;                                  ///< [W]
  Real sliding_loss = 0.0;                                  ///< [J]
  Real elastic = 0.0;                                       ///< recorded [J]
  Real attractive = 0.0;                                    ///< recorded [J]
  Real deepest = -std::numeric_limits<double>::infinity();  ///< overlap beyond the limit [m]

  template <SumsInUse in_use>
  void add(const ContactSums& other) {
    using simd::larger;
    damping_power += other.damping_power;
    if constexpr (in_use.plastic) plastic_loss += other.plastic_loss;
    if constexpr (in_use.growth) growth_power += other.growth_power;
    if constexpr (in_use.sliding) sliding_loss += other.sliding_loss;
    if constexpr (in_use.recorded) {
      elastic += other.elastic;
      attractive += other.attractive;
    }
    deepest = larger(other.deepest, deepest);
  }

  /// Each of them through a function.
  template <class Function>
  auto map(const Function& f) const -> ContactSums<decltype(f(damping_power))> {
    return {f(damping_power), f(plastic_loss), f(growth_power), f(sliding_loss), f(elastic), f(attractive), f(deepest)};
  }

  /// share: of these energies that is this side's.
  void add_to(StepSums& to, const StepInput& in, double share) const {
    using simd::sum;
    to.dissipated_normal += share * (in.dt * sum(damping_power) + sum(plastic_loss));
    to.dissipated_tangential += share * sum(sliding_loss);
    to.growth_work += share * in.dt * sum(growth_power);
    to.elastic += share * sum(elastic);
    to.attractive += share * sum(attractive);
  }
};

template <class Lanes>
struct LaneSums {
  using Real = typename Lanes::Real;
  using Vector = simd::Vector<Real>;
  static constexpr std::uint32_t all_lanes = (1u << Lanes::width) - 1;

  ContactSums<Real> pairs, walls;
  Vector momentum = Vector::zero();                              ///< half a step on [kg m/s]
  Vector displacement = Vector::zero();                          ///< [m]
  Real largest_share_squared = 0.0;                              ///< of a margin used up
  typename Lanes::Mask within_margins = Lanes::mask(all_lanes);  ///< not where a share is not a number
  StepSums recorded;

  void add_to(BlockResult& result, const StepInput& in) const {
    using simd::bits, simd::largest;
    constexpr double one_of_two = 0.5;  // both particles of a pair see their contact
    StepSums& s = result.sums;
    pairs.add_to(s, in, one_of_two);
    walls.add_to(s, in, 1);
    s.gravity_work += in.dt * in.gravity.dot(total(momentum));
    // A share that is not a number hides from the largest, but not from the mask.
    const double share = largest(largest_share_squared);
    const bool known = bits(within_margins) == all_lanes || share >= 1;
    s.largest_share_squared =
        std::max(s.largest_share_squared, known ? share : std::numeric_limits<double>::infinity());
    s.add(recorded);
    result.displacement += total(displacement);
  }
  bool beyond_limit() const {
    using simd::largest, simd::larger;
    return largest(larger(pairs.deepest, walls.deepest)) > 0;
  }

 private:
  static Vec3 total(const Vector& v) {
    using simd::sum;
    return {sum(v.x), sum(v.y), sum(v.z)};
  }
};

}  // namespace packstone::engine
