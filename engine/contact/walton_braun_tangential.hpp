// Tangential stiffness that falls with the force and recovers on reversal: Walton & Braun, J. Rheol. 30 (1986) 949;
// Zhong et al., Acta Phys. Sin. 58 (2009), eqs [26], [27], model X.
#pragma once

#include "engine/contact/law.hpp"
#include "engine/contact/tangential_force.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// dF = K_t d_s with, F the force's size and L = mu |F_n|,
///   K_t = K_0 ((L - F)/(L - F*))^(1/3) away from the last reversal, K_0 ((L + F)/(L + F*))^(1/3) going back
/// (the minus printed before K_0 in [27b] would make the stiffness negative). F*: F at the last reversal, 0 at first,
/// held within L. Displacements across the force meet K_0 (Walton, in Particulate Two-Phase Flow (1993) ch. 25).
/// A step follows the law exactly as long as F_n and the direction hold, so a step of any length ends within L.
struct WaltonBraunTangential : WithoutSizes {
  static constexpr int most_kept = 4;  ///< the force that the second body feels [N], F*

  template <class T>
  struct Parameters {
    T stiffness;  ///< K_0 [N/m]
    T friction;   ///< mu

    static constexpr int count = 2;
  };

  template <class T>
  using Coefficients = Parameters<T>;

  /// The stored energy is that of the stiffness K_0, F^2 / (2 K_0); what the work leaves beside it is dissipated.
  template <class T, class Kept>
  [[gnu::always_inline]] static TangentialForce<T> advance(const Coefficients<T>& pair, const Slip<T>& slip,
                                                           Kept& kept) {
    using simd::absolute, simd::cube_root, simd::fused, simd::inverse_sqrt, simd::larger, simd::only, simd::select,
        simd::smaller, simd::square_root, simd::squared_length;
    const simd::Vector<T> before = turned_into_plane(kept_vector(kept), slip.normal, simd::Vector<T>::zero());
    const simd::Vector<T> displacement = T(slip.dt) * slip.velocity;
    const SplitDisplacement<T> part = split(displacement, before);
    const T limit = pair.friction * absolute(slip.normal_force);
    const T force = smaller(part.force, limit);
    T reversal = larger(-limit, smaller(kept[3], limit));
    const auto away = T(0.0) < part.along;
    const auto turns = (away & (force < reversal)) | ((part.along < T(0.0)) & (reversal < force));
    reversal = select(turns, force, reversal);
    // Of the range from the reversal to the limit, the share that is left; its power 2/3 falls with the displacement.
    const T sign = select(away, T(1.0), T(-1.0));
    const T range = fused(-sign, reversal, limit), left = fused(-sign, force, limit);
    const T inverse_range = only(T(0.0) < range, T(1.0) / range);
    const T root = cube_root(smaller(left * inverse_range, T(1.0)));
    const T power =
        larger(fused(T(-2.0 / 3) * pair.stiffness * inverse_range, absolute(part.along), root * root), T(0.0));
    const T along = sign * fused(-range * power, square_root(power), limit);
    simd::Vector<T> now = fused(pair.stiffness, part.across, along * part.direction);

    const T now_squared = squared_length(now);
    const T share = limit * inverse_sqrt(larger(now_squared, T(no_length_squared)));
    TangentialForce<T> f;
    f.sliding = (share < T(1.0)) | ((power < T(no_length_squared)) & (T(0.0) < absolute(part.along)));
    now = smaller(share, T(1.0)) * now;
    kept[3] = select(along < T(0.0), -reversal, reversal);
    keep_vector(now, kept);
    f.force = -now;
    const T inverse_twice = T(0.5) / pair.stiffness;
    f.elastic = inverse_twice * squared_length(now);
    f.dissipated = fused(T(0.5), dot(before + now, displacement), inverse_twice * squared_length(before) - f.elastic);
    return f;
  }
};

}  // namespace packstone::engine
