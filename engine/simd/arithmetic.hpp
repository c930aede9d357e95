// Operators that are the same for vector registers of any width.
#pragma once

namespace packstone::engine::simd {

/// For a Real with a register `v` of the compiler's vector type.
template <class Real>
struct Arithmetic {
  friend Real operator+(Real a, Real b) { return a.v + b.v; }
  friend Real operator-(Real a, Real b) { return a.v - b.v; }
  friend Real operator*(Real a, Real b) { return a.v * b.v; }
  friend Real operator/(Real a, Real b) { return a.v / b.v; }
  friend Real operator-(Real a) { return -a.v; }
  friend Real& operator+=(Real& a, Real b) { return a = a + b; }
};

}  // namespace packstone::engine::simd
