// Attraction between surfaces: Zhong et al., Acta Phys. Sin. 58 (2009), eq. [28] (whose printed sign repels).
#pragma once

#include "core/scene.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// F = A R_eff / (6 h^2) at a gap h between the surfaces of two spheres, or of a sphere and a plane; h no smaller than
/// a smallest gap, so that contacts are pulled together by the force there; nothing beyond a cut-off.
class VanDerWaals {
 public:
  explicit VanDerWaals(const VanDerWaalsSpec& spec)
      : sixth_of_hamaker_(spec.hamaker / 6), min_gap_(spec.min_gap), range_(spec.range()) {}

  /// Gap at which it ends [m]; 0 where there is none.
  double range() const { return range_; }

  /// Pull on each body [N], at a gap within the range; negative gaps are overlaps [m].
  template <class T>
  [[gnu::always_inline]] T force(const T& effective_radius, const T& gap) const {
    using simd::larger;
    const T inverse = T(1.0) / larger(gap, T(min_gap_));
    return T(sixth_of_hamaker_) * effective_radius * inverse * inverse;
  }

  /// Its potential, 0 at the cut-off [J].
  template <class T>
  [[gnu::always_inline]] T energy(const T& effective_radius, const T& gap) const {
    using simd::larger;
    const T strength = T(sixth_of_hamaker_) * effective_radius;
    const T inverse = T(1.0) / larger(gap, T(min_gap_));
    const T nearer = larger(T(min_gap_) - gap, T(0.0));  // than the smallest gap, where the force is constant
    return -strength * (inverse - T(1 / range_) + inverse * inverse * nearer);
  }

 private:
  double sixth_of_hamaker_;
  double min_gap_;
  double range_;
};

}  // namespace packstone::engine
