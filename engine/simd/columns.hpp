// Rows of numbers turned into columns, one lane a row: the same two ways in for lanes of any kind.
#pragma once

#include <cstddef>
#include <cstdint>

namespace packstone::engine::simd {

/// For Lanes with a function read<columns>(row, column), where row(k) is where lane k's row begins.
template <class Lanes, class Number>
struct ReadsColumns {
  /// Reads three or four consecutive numbers of one row a lane; that of lane k begins at base + offset[k].
  template <int columns, class Real>
  [[gnu::always_inline]] static void read_columns(const Number* base, const std::uint32_t* offset, Real* column) {
    Lanes::template read<columns>([&](int k) { return base + offset[k]; }, column);
  }
  /// The same of `width` rows in sequence.
  template <int columns, std::size_t stride, class Real>
  [[gnu::always_inline]] static void read_columns(const Number* rows, Real* column) {
    Lanes::template read<columns>([&](int k) { return rows + stride * static_cast<std::size_t>(k); }, column);
  }
};

}  // namespace packstone::engine::simd
