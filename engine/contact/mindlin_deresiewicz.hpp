// Elastic spheres that slip from the edge of their contact inwards: Mindlin & Deresiewicz, J. Appl. Mech. 20 (1953)
// 327, in the form of Thornton & Yin, Powder Technol. 65 (1991) 153; Zhong et al., Acta Phys. Sin. 58 (2009), eqs
// [19]-[21], model VI.
#pragma once

#include "engine/contact/normal_force.hpp"
#include "engine/contact/tangential_force.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// dF = 8 a G* theta_k d_s + (-1)^k mu (1 - theta_k) dF_n, k = 0 loading, 1 unloading, 2 loading again, with a =
/// sqrt(R_eff xi), 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2 ([21] prints the inverse), L = mu F_n and dL its change:
///   theta_0^3 = 1 - (F + dL)/L,  theta_1^3 = 1 - (F* - F + 2 dL)/(2 L),  theta_2^3 = 1 - (F - F** + 2 dL)/(2 L),
/// F* and F** where unloading and loading again began, moved by dL and -dL. In a step in which the limit grows by more
/// than the stuck contact's force, theta = 1. Where F passes zero, its direction turns round: unloading goes on as
/// loading again of the mirrored contact. Of reversals within reversals the last two are remembered. Displacements
/// across the force meet the stiffness of the stuck contact.
struct MindlinDeresiewicz {
  /// The force that the second body feels (3), F*, F** [N], k, L [N], stored energy [J].
  static constexpr int most_kept = 8;

  template <class T>
  struct Parameters {
    T modulus;   ///< G* [Pa]
    T friction;  ///< mu

    static constexpr int count = 2;
  };

  template <class T>
  struct Coefficients {
    T stiffness;  ///< of the stuck contact over sqrt(xi), 8 G* sqrt(R_eff) [N/m^(3/2)]
    T friction;
  };
  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Parameters<T>& pair, const PairSize<T>& size) {
    using simd::square_root;
    return {T(8.0) * pair.modulus * square_root(size.effective_radius), pair.friction};
  }

  /// The stored energy is that of the stuck contact, F^2 / (16 a G*); what the work leaves beside it is dissipated.
  template <class T, class Kept>
  [[gnu::always_inline]] static TangentialForce<T> advance(const Coefficients<T>& pair, const Slip<T>& slip,
                                                           Kept& kept) {
    using simd::absolute, simd::cube_root, simd::fused, simd::inverse_sqrt, simd::larger, simd::only, simd::select,
        simd::smaller, simd::square_root, simd::squared_length;
    T &unloading_from = kept[3], &loading_from = kept[4], &phase = kept[5], &limit = kept[6], &energy = kept[7];
    const simd::Vector<T> before = turned_into_plane(kept_vector(kept), slip.normal, simd::Vector<T>::zero());
    const simd::Vector<T> displacement = T(slip.dt) * slip.velocity;
    const SplitDisplacement<T> part = split(displacement, before);
    const T stiffness = pair.stiffness * square_root(slip.overlap);
    const T limit_before = limit;
    limit = pair.friction * absolute(slip.normal_force);
    const T limit_change = limit - limit_before;

    const auto back = part.along < T(0.0), on = T(0.0) < part.along;
    const auto was_loading = phase < T(loading + 0.5), was_reloading = T(reloading - 0.5) < phase;
    const auto was_unloading = (T(loading + 0.5) < phase) & (phase < T(reloading - 0.5));
    const auto unloads = back & (was_loading | was_reloading), reloads = on & was_unloading;
    loading_from = select(back & was_loading, -part.force, select(reloads, part.force, loading_from));
    unloading_from = select(unloads, part.force, unloading_from);
    phase = select(unloads, T(unloading), select(reloads, T(reloading), phase));

    const auto at_first = phase < T(loading + 0.5), at_last = T(reloading - 0.5) < phase;
    const T passed =
        select(at_first, part.force, select(at_last, part.force - loading_from, unloading_from - part.force));
    const T range = select(at_first, limit, T(2.0) * limit);
    const T grown = select(at_first, limit_change, T(2.0) * limit_change);
    const T inverse_range = only(T(0.0) < range, T(1.0) / range);
    // theta^3 before the step; as dF = 8 a G* theta d_s, its power 2/3 falls with the displacement.
    const T cube = larger(T(0.0), smaller(T(1.0), T(1.0) - (passed + grown) * inverse_range));
    const T theta = cube_root(cube);
    const T power = larger(fused(T(-2.0 / 3) * stiffness * inverse_range, absolute(part.along), theta * theta), T(0.0));
    const T used = range * (cube - power * square_root(power));  // of the range, by this step
    const T stuck_change = stiffness * absolute(part.along);
    const T mean_theta = select(T(0.0) < stuck_change, smaller(used / stuck_change, T(1.0)), theta);

    const auto stuck = stiffness * square_root(squared_length(displacement)) < limit_change;
    const T share = select(stuck, T(1.0), mean_theta);
    const T sign = select(on, T(1.0), only(back, T(-1.0)));
    const T branch = select(at_first | at_last, T(1.0), T(-1.0));
    const T along = part.force + sign * share * stuck_change + branch * (T(1.0) - share) * limit_change;
    unloading_from += limit_change;
    loading_from = loading_from - limit_change;

    simd::Vector<T> now = fused(stiffness, part.across, along * part.direction);
    const T held = limit * inverse_sqrt(larger(squared_length(now), T(no_length_squared)));
    TangentialForce<T> f;
    f.sliding = held < T(1.0);
    now = smaller(held, T(1.0)) * now;

    const auto mirrored = along < T(0.0);
    const T unloading_here = unloading_from;
    unloading_from = select(mirrored, -loading_from, unloading_from);
    loading_from = select(mirrored, -unloading_here, loading_from);
    phase = select(mirrored & (T(loading + 0.5) < phase), T(unloading + reloading) - phase, phase);
    // Loading again reaches the curve of first loading where unloading had left it.
    const auto joined = (T(reloading - 0.5) < phase) & (unloading_from < absolute(along));
    phase = select(joined, T(loading), phase);

    keep_vector(now, kept);
    f.force = -now;
    f.elastic = only(T(0.0) < stiffness, T(0.5) * squared_length(now) / stiffness);
    f.dissipated = fused(T(0.5), dot(before + now, displacement), energy - f.elastic);
    energy = f.elastic;
    return f;
  }

 private:
  static constexpr double loading = 0, unloading = 1, reloading = 2;  ///< k
};

}  // namespace packstone::engine
