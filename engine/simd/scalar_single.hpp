// One lane of single precision, for portable builds.
#pragma once

#include <bit>
#include <cstring>

#include "engine/simd/scalar.hpp"

namespace packstone::engine::simd {

struct ScalarSingle : ReadsColumns<ScalarSingle, float> {
  using Whole = Scalar;  ///< lanes that this one's are widened to
  using Real = float;
  using Mask = bool;
  static constexpr int width = 1;
  static constexpr const char* name = "portable, single precision";

  static double lane(Real x, int) { return x; }
  static Mask mask(std::uint32_t lanes) { return (lanes & 1u) != 0; }
  static Real load(const float* p) { return *p; }
  static void store(float* p, Real x) { *p = x; }
  static Real gather(const double* table, const std::int32_t* index) { return static_cast<float>(table[*index]); }

  /// Lanes part * Whole::width on.
  static double widened(Real x, int /*part*/) { return x; }
  /// Of two columns of integers, modulo 2^32, as numbers.
  static Real difference_of_places(Real a, Real b) {
    return static_cast<float>(
        static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(a) - std::bit_cast<std::uint32_t>(b)));
  }

  /// Writes first + k for each lane k of the mask, in ascending order; returns how many. May write `width` values.
  static int write_indices(Mask mask, std::int32_t first, std::int32_t* to) {
    *to = first;
    return mask;
  }

  /// Words of either kind, so byte by byte.
  template <int columns, class RowAt>
  static void read(const RowAt& row, Real* column) {
    std::memcpy(column, row(0), columns * sizeof(Real));
  }
};

}  // namespace packstone::engine::simd
