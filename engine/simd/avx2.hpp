// Four lanes in AVX2 registers with fused multiply-add. See scalar.hpp for what each operation means.
#pragma once

#if defined(__AVX2__) && defined(__FMA__)
#define PACKSTONE_AVX2 1

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <immintrin.h>

#include "engine/simd/arithmetic.hpp"
#include "engine/simd/columns.hpp"

namespace packstone::engine::simd {

struct Avx2 : ReadsColumns<Avx2, double> {
  static constexpr int width = 4;
  static constexpr const char* name = "AVX2";

  struct Mask {
    __m256d lanes;  ///< all bits of a lane set or none

    friend Mask operator&(Mask a, Mask b) { return {_mm256_and_pd(a.lanes, b.lanes)}; }
    friend Mask operator|(Mask a, Mask b) { return {_mm256_or_pd(a.lanes, b.lanes)}; }
    friend bool any(Mask m) { return _mm256_movemask_pd(m.lanes) != 0; }
    friend std::uint32_t bits(Mask m) { return static_cast<std::uint32_t>(_mm256_movemask_pd(m.lanes)); }
  };

  struct Real : Arithmetic<Real> {
    __m256d v;

    Real() = default;
    Real(double x) : v(_mm256_set1_pd(x)) {}
    Real(__m256d x) : v(x) {}

    friend Mask operator<(Real a, Real b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)}; }
    friend Mask operator>(Real a, Real b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }

    friend Real fused(Real a, Real b, Real c) { return _mm256_fmadd_pd(a.v, b.v, c.v); }
    friend Real fused_where(Mask m, Real a, Real b, Real c) { return select(m, fused(a, b, c), c); }
    friend Real select(Mask m, Real yes, Real no) { return _mm256_blendv_pd(no.v, yes.v, m.lanes); }
    friend Real only(Mask m, Real x) { return _mm256_and_pd(m.lanes, x.v); }
    /// b where either is not a number.
    friend Real larger(Real a, Real b) { return _mm256_max_pd(a.v, b.v); }
    /// b where either is not a number.
    friend Real smaller(Real a, Real b) { return _mm256_min_pd(a.v, b.v); }
    friend Real square_root(Real x) { return _mm256_sqrt_pd(x.v); }
    friend Real cube_root(Real x) {
      for (int k = 0; k < width; ++k) x.v[k] = std::cbrt(x.v[k]);
      return x;
    }
    friend Real absolute(Real a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v); }
    friend Real nearest_integer(Real a) { return _mm256_round_pd(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }
    friend Real inverse_sqrt(Real x) { return Real(1.0) / Real(_mm256_sqrt_pd(x.v)); }
    friend Real rough_reciprocal(Real x) { return Real(1.0) / x; }
    friend double sum(Real x) { return (x.v[0] + x.v[2]) + (x.v[1] + x.v[3]); }
    friend double largest(Real x) {
      const double a = x.v[0] > x.v[2] ? x.v[0] : x.v[2], b = x.v[1] > x.v[3] ? x.v[1] : x.v[3];
      return a > b ? a : b;
    }
  };

  static Real load(const double* p) { return _mm256_loadu_pd(p); }
  static void store(double* p, Real x) { _mm256_storeu_pd(p, x.v); }
  static double lane(Real x, int k) { return x.v[k]; }
  static Mask mask(std::uint32_t lanes) {
    const __m256i bit = _mm256_setr_epi64x(1, 2, 4, 8);
    return {_mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(lanes), bit), bit))};
  }
  static Real gather(const double* table, const std::int32_t* index) {
    return _mm256_setr_pd(table[index[0]], table[index[1]], table[index[2]], table[index[3]]);
  }

  template <std::size_t stride>
  [[gnu::always_inline]] static void write_columns(double* rows, const Real* column) {
    __m256d row[4];
    transpose(column[0].v, column[1].v, column[2].v, column[3].v, row);
    for (int k = 0; k < 4; ++k) _mm256_storeu_pd(rows + stride * k, row[k]);
  }

  using Word = __m128;
  static Word narrowed(Real x) { return _mm256_cvtpd_ps(x.v); }
  static Word low_word(Real x) {
    const __m256 words = _mm256_castpd_ps(x.v);
    constexpr int even = 0x88;
    return _mm_shuffle_ps(_mm256_castps256_ps128(words), _mm256_extractf128_ps(words, 1), even);
  }
  template <std::size_t stride>
  [[gnu::always_inline]] static void write_words(float* rows, const Word* column) {
    Word row[4] = {column[0], column[1], column[2], column[3]};
    _MM_TRANSPOSE4_PS(row[0], row[1], row[2], row[3]);
    for (std::size_t k = 0; k < 4; ++k) _mm_storeu_ps(rows + stride * k, row[k]);
  }

 private:
  friend struct ReadsColumns<Avx2, double>;

  static void transpose(__m256d a, __m256d b, __m256d c, __m256d d, __m256d* to) {
    const __m256d ab_even = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
    const __m256d cd_even = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
    to[0] = _mm256_permute2f128_pd(ab_even, cd_even, 0x20);
    to[1] = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20);
    to[2] = _mm256_permute2f128_pd(ab_even, cd_even, 0x31);
    to[3] = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31);
  }

  template <int columns, class RowAt>
  [[gnu::always_inline]] static void read(const RowAt& row, Real* column) {
    __m256d all[4];
    transpose(_mm256_loadu_pd(row(0)), _mm256_loadu_pd(row(1)), _mm256_loadu_pd(row(2)), _mm256_loadu_pd(row(3)), all);
    for (int c = 0; c < columns; ++c) column[c].v = all[c];
  }
};

}  // namespace packstone::engine::simd

#endif
