// What tangential laws are given and what they return.
#pragma once

#include <array>

#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// A contact that slides. T: a number, or lanes of them.
template <class T>
struct Slip {
  const simd::Vector<T>& normal;    ///< unit vector from the second body to the first
  const simd::Vector<T>& velocity;  ///< of the first body's surface over the second's, in the contact plane [m/s]
  const T& normal_force;            ///< elastic and damping, attraction left out [N]
  const T& overlap;                 ///< [m] > 0
  double dt;                        ///< since the step before [s]
};

template <class T>
struct TangentialForce {
  using Mask = decltype(T() < T());
  simd::Vector<T> force;  ///< on the first body [N]
  T dissipated;           ///< by sliding in this step [J]
  T elastic;              ///< stored in the contact [J]
  Mask sliding;           ///< where friction is at Coulomb's limit
};

/// Squares below this count as none [m2, m2/s2]: the reciprocal of much less overflows in single precision.
inline constexpr double no_length_squared = 1e-36;

/// A vector of a contact plane that has turned by a small angle since, brought into the plane with its length kept, and
/// another one added.
template <class T>
[[gnu::always_inline]] inline simd::Vector<T> turned_into_plane(const simd::Vector<T>& vector,
                                                                const simd::Vector<T>& normal,
                                                                const simd::Vector<T>& added) {
  using simd::fused, simd::only, simd::rough_reciprocal, simd::squared_length;
  const T along = dot(vector, normal);
  const simd::Vector<T> turned = fused(-along, normal, vector);
  // x: the tangent of the angle, squared.
  const T turned_squared = squared_length(turned);
  const T x = only(T(no_length_squared) < turned_squared, along * along * rough_reciprocal(turned_squared));
  const T stretch = fused(fused(T(-1.0 / 8), x, T(0.5)), x, T(1.0));  // sqrt(1 + x)
  return fused(stretch, turned, added);
}

/// The part of a displacement along what the contact's force has been so far, and the part across.
template <class T>
struct SplitDisplacement {
  T force;                    ///< of the contact, as large as it is [N]
  simd::Vector<T> direction;  ///< its own; the displacement's where there is none
  T along;                    ///< [m]
  simd::Vector<T> across;     ///< [m]
};
template <class T>
[[gnu::always_inline]] inline SplitDisplacement<T> split(const simd::Vector<T>& displacement,
                                                         const simd::Vector<T>& force) {
  using simd::fused, simd::inverse_sqrt, simd::only, simd::select, simd::squared_length;
  const T force_squared = squared_length(force), length_squared = squared_length(displacement);
  const auto acts = T(no_length_squared) < force_squared;
  const T inverse_force = only(acts, inverse_sqrt(force_squared));
  const T inverse_length = only(T(no_length_squared) < length_squared, inverse_sqrt(length_squared));
  const auto either = [&](const T& f, const T& d) __attribute__((always_inline)) {
    return select(acts, f * inverse_force, d * inverse_length);
  };
  SplitDisplacement<T> s;
  s.force = force_squared * inverse_force;
  s.direction = {either(force.x, displacement.x), either(force.y, displacement.y), either(force.z, displacement.z)};
  s.along = dot(displacement, s.direction);
  s.across = fused(-s.along, s.direction, displacement);
  return s;
}

/// Laws keep vectors in sequences of numbers.
template <class Kept>
[[gnu::always_inline]] inline auto kept_vector(const Kept& kept) {
  return simd::Vector<typename Kept::value_type>{kept[0], kept[1], kept[2]};
}
template <class Kept>
[[gnu::always_inline]] inline void keep_vector(const simd::Vector<typename Kept::value_type>& v, Kept& kept) {
  kept[0] = v.x;
  kept[1] = v.y;
  kept[2] = v.z;
}

}  // namespace packstone::engine
