// Vectors in space whose components are numbers or lanes of numbers. Inlined without exception: a call would pass them
// through memory.
#pragma once

#include "engine/simd/scalar.hpp"

namespace packstone::engine::simd {

template <class T>
struct Vector {
  T x, y, z;

  [[gnu::always_inline]] static Vector zero() { return {T(0.0), T(0.0), T(0.0)}; }

  [[gnu::always_inline]] friend Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
  [[gnu::always_inline]] friend Vector operator*(const T& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
  [[gnu::always_inline]] Vector& operator+=(const Vector& b) { return *this = *this + b; }
  [[gnu::always_inline]] Vector& operator-=(const Vector& b) { return *this = *this - b; }
};

template <class T>
[[gnu::always_inline]] inline T dot(const Vector<T>& a, const Vector<T>& b) {
  return fused(a.x, b.x, fused(a.y, b.y, a.z * b.z));
}

template <class T>
[[gnu::always_inline]] inline T squared_length(const Vector<T>& a) {
  return dot(a, a);
}

template <class T>
[[gnu::always_inline]] inline Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {fused(-a.z, b.y, a.y * b.z), fused(-a.x, b.z, a.z * b.x), fused(-a.y, b.x, a.x * b.y)};
}

/// s a + b.
template <class T>
[[gnu::always_inline]] inline Vector<T> fused(const T& s, const Vector<T>& a, const Vector<T>& b) {
  return {fused(s, a.x, b.x), fused(s, a.y, b.y), fused(s, a.z, b.z)};
}

/// s a + b where the mask holds, b elsewhere.
template <class Mask, class T>
[[gnu::always_inline]] inline Vector<T> fused_where(Mask mask, const T& s, const Vector<T>& a, const Vector<T>& b) {
  return {fused_where(mask, s, a.x, b.x), fused_where(mask, s, a.y, b.y), fused_where(mask, s, a.z, b.z)};
}

/// a where the mask holds, 0 elsewhere.
template <class Mask, class T>
[[gnu::always_inline]] inline Vector<T> only(Mask mask, const Vector<T>& a) {
  return {only(mask, a.x), only(mask, a.y), only(mask, a.z)};
}

}  // namespace packstone::engine::simd
