// Lanes of one: plain numbers with the operations that the vector types have, for portable builds and for laws that are
// evaluated one contact at a time.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace packstone::engine::simd {

/// a b + c, rounded once where the processor has the instruction.
inline double fused(double a, double b, double c) {
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}
/// a b + c where the mask holds, c elsewhere.
inline double fused_where(bool mask, double a, double b, double c) { return mask ? fused(a, b, c) : c; }
inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
/// x where the mask holds, 0 elsewhere, whatever x is there.
inline double only(bool mask, double x) { return mask ? x : 0.0; }
/// b where either is not a number.
inline double larger(double a, double b) { return a > b ? a : b; }
inline double absolute(double a) { return std::abs(a); }
inline double nearest_integer(double a) { return std::nearbyint(a); }
/// 1/sqrt(x), to the last bit or two.
inline double inverse_sqrt(double x) { return 1 / std::sqrt(x); }
/// 1/x, to half the bits at least.
inline double rough_reciprocal(double x) { return 1 / x; }
inline bool any(bool mask) { return mask; }
inline std::uint32_t bits(bool mask) { return mask ? 1u : 0u; }
inline double sum(double x) { return x; }
inline double largest(double x) { return x; }

/// The set of operations with one lane.
struct Scalar {
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

  /// Reads `columns` consecutive doubles of one row a lane; that of lane k begins at base + offset[k].
  template <int columns>
  static void read_columns(const double* base, const std::uint32_t* offset, Real* column) {
    const double* row = base + *offset;
    for (int c = 0; c < columns; ++c) column[c] = row[c];
  }
  /// The same of `width` rows in sequence.
  template <int columns, std::size_t stride>
  static void read_columns(const double* rows, Real* column) {
    for (int c = 0; c < columns; ++c) column[c] = rows[c];
  }
  /// Writes four columns into `width` rows in sequence.
  template <std::size_t stride>
  static void write_columns(double* rows, const Real* column) {
    for (int c = 0; c < 4; ++c) rows[c] = column[c];
  }
  /// Writes first + k for each lane k of the mask, in ascending order; returns how many. May write `width` values.
  static int write_indices(Mask mask, std::int32_t first, std::int32_t* to) {
    *to = first;
    return mask;
  }
};

}  // namespace packstone::engine::simd
