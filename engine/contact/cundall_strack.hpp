// Tangential spring with Coulomb's limit: Zhong et al., Acta Phys. Sin. 58 (2009), eqs [24], [25], model IX;
// Cundall & Strack, Geotechnique 29 (1979) 47.
#pragma once

#include <array>

#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// F_s = -k_s s, with s the tangential displacement since the contact began, kept in the contact plane; the spring
/// slides with the contact where it would exceed mu |F_n|. The force follows the spring, not sgn(v_s) as printed.
struct CundallStrack {
  static constexpr bool active = true;
  /// Of a spring [m2]: the reciprocal of much less overflows in single precision.
  static constexpr double shortest_squared = 1e-36;

  template <class T>
  struct Parameters {
    T stiffness;  ///< k_s [N/m]
    T friction;   ///< mu

    static constexpr int count = 2;
    std::array<T, count> values() const { return {stiffness, friction}; }
    template <class Source>
    static Parameters from(Source&& parameter) {
      return {parameter(0), parameter(1)};
    }
  };

  template <class T>
  struct Force {
    using Mask = decltype(T() < T());
    simd::Vector<T> force;  ///< on the first body [N]
    T dissipated;           ///< by sliding in this step [J]
    T elastic;              ///< stored in the spring [J]
    Mask sliding;
  };

  /// Advances the spring [m] by a step dt [s] at a sliding velocity [m/s] in the contact plane to the instant of the
  /// forces. With the velocity half a step before that instant, this is the leapfrog scheme, of second order and
  /// without gain or loss. Swapping the bodies negates normal, velocity and spring, and gives exactly the negated
  /// force.
  template <class T>
  [[gnu::always_inline]] static Force<T> advance(const Parameters<T>& pair, simd::Vector<T>& spring,
                                                 const simd::Vector<T>& normal, const simd::Vector<T>& sliding_velocity,
                                                 const T& normal_force, double dt) {
    using simd::absolute, simd::fused, simd::inverse_sqrt, simd::only, simd::rough_reciprocal, simd::select,
        simd::squared_length;
    const T along = dot(spring, normal);
    simd::Vector<T> now = fused(-along, normal, spring);
    // The contact plane turns by a small angle, whose tangent squared is x; the spring keeps its length.
    const T turned_squared = squared_length(now);
    const T x = only(T(shortest_squared) < turned_squared, along * along * rough_reciprocal(turned_squared));
    const T stretch = fused(fused(T(-1.0 / 8), x, T(0.5)), x, T(1.0));  // sqrt(1 + x)
    const simd::Vector<T> displacement = T(dt) * sliding_velocity;
    now = fused(stretch, now, displacement);
    const T now_squared = squared_length(now);
    const T limit_force = pair.friction * absolute(normal_force);
    const T share = limit_force * inverse_sqrt(pair.stiffness * pair.stiffness * now_squared);
    Force<T> f;
    f.sliding = share < T(1.0);
    const T kept = select(f.sliding, share, T(1.0));
    spring = kept * now;
    f.force = -pair.stiffness * spring;
    const T half_stiffness = T(0.5) * pair.stiffness;
    // Work done on the spring in this step less the change of its energy.
    f.dissipated = half_stiffness * (T(1.0) - kept) * fused(T(1.0) + kept, now_squared, -dot(displacement, now));
    f.elastic = half_stiffness * squared_length(spring);
    return f;
  }
};

}  // namespace packstone::engine
