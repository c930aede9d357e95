// Lanes of one: plain numbers with the operations that the vector types have, for portable builds and for laws that are
// evaluated one contact at a time.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "engine/simd/columns.hpp"

namespace packstone::engine::simd {

/// a b + c, rounded once where the processor has the instruction.
template <std::floating_point T>
T fused(T a, T b, T c) {
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}
/// a b + c where the mask holds, c elsewhere.
template <std::floating_point T>
T fused_where(bool mask, T a, T b, T c) {
  return mask ? fused(a, b, c) : c;
}
template <std::floating_point T>
T select(bool mask, T yes, T no) {
  return mask ? yes : no;
}
/// x where the mask holds, 0 elsewhere, whatever x is there.
template <std::floating_point T>
T only(bool mask, T x) {
  return mask ? x : T(0);
}
/// b where either is not a number.
template <std::floating_point T>
T larger(T a, T b) {
  return a > b ? a : b;
}
/// b where either is not a number.
template <std::floating_point T>
T smaller(T a, T b) {
  return a < b ? a : b;
}
template <std::floating_point T>
T absolute(T a) {
  return std::abs(a);
}
template <std::floating_point T>
T nearest_integer(T a) {
  return std::nearbyint(a);
}
/// 1/sqrt(x), to the last bit or two.
template <std::floating_point T>
T inverse_sqrt(T x) {
  return 1 / std::sqrt(x);
}
template <std::floating_point T>
T square_root(T x) {
  return std::sqrt(x);
}
template <std::floating_point T>
T cube_root(T x) {
  return std::cbrt(x);
}
/// 1/x, to half the bits at least.
template <std::floating_point T>
T rough_reciprocal(T x) {
  return 1 / x;
}
inline bool any(bool mask) { return mask; }
inline std::uint32_t bits(bool mask) { return mask ? 1u : 0u; }
/// Over the lanes.
inline double sum(double x) { return x; }
inline double largest(double x) { return x; }

/// The set of operations with one lane.
struct Scalar : ReadsColumns<Scalar, double> {
  using Real = double;
  using Mask = bool;
  static constexpr int width = 1;
  static constexpr const char* name = "portable";

  static Real load(const double* p) { return *p; }
  static void store(double* p, Real x) { *p = x; }
  static double lane(Real x, int) { return x; }
  static Mask mask(std::uint32_t lanes) { return (lanes & 1u) != 0; }
  /// table[index] of every lane.
  static Real gather(const double* table, const std::int32_t* index) { return table[*index]; }

  /// For ReadsColumns.
  template <int columns, class RowAt>
  static void read(const RowAt& row, Real* column) {
    std::copy_n(row(0), columns, column);
  }
  /// Writes four columns into `width` rows in sequence.
  template <std::size_t stride>
  static void write_columns(double* rows, const Real* column) {
    for (int c = 0; c < 4; ++c) rows[c] = column[c];
  }
  /// A lane each of 32 bits, and how they come from numbers: rounded, or the low half of their bits.
  using Word = float;
  static Word narrowed(Real x) { return static_cast<float>(x); }
  static Word low_word(Real x) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x)));
  }
  /// Writes four columns of words into `width` rows in sequence.
  template <std::size_t stride>
  static void write_words(float* rows, const Word* column) {
    for (int c = 0; c < 4; ++c) rows[c] = column[c];
  }
};

}  // namespace packstone::engine::simd
