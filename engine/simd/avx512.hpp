// Eight lanes in AVX-512 registers (F, DQ, VL). See scalar.hpp for what each operation means.
#pragma once

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define PACKSTONE_AVX512 1

#include <bit>
#include <cstddef>
#include <cstdint>

#include <immintrin.h>

#include "engine/simd/arithmetic.hpp"
#include "engine/simd/columns.hpp"

namespace packstone::engine::simd {

struct Avx512 : ReadsColumns<Avx512, double> {
  static constexpr int width = 8;
  static constexpr const char* name = "AVX-512";

  /// The plain forms of some intrinsics make GCC 12 warn of undefined registers in its own header (GCC bug 105593);
  /// their masked forms with all lanes are the same instructions.
  static constexpr __mmask8 all = 0xff;

  struct Mask {
    __mmask8 bits = 0;

    friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
    friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
    friend bool any(Mask m) { return m.bits != 0; }
    friend std::uint32_t bits(Mask m) { return m.bits; }
  };

  struct Real : Arithmetic<Real> {
    __m512d v;

    Real() = default;
    Real(double x) : v(_mm512_set1_pd(x)) {}
    Real(__m512d x) : v(x) {}

    friend Mask operator<(Real a, Real b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)}; }
    friend Mask operator>(Real a, Real b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)}; }

    friend Real fused(Real a, Real b, Real c) { return _mm512_fmadd_pd(a.v, b.v, c.v); }
    friend Real fused_where(Mask m, Real a, Real b, Real c) { return _mm512_mask3_fmadd_pd(a.v, b.v, c.v, m.bits); }
    friend Real select(Mask m, Real yes, Real no) { return _mm512_mask_blend_pd(m.bits, no.v, yes.v); }
    friend Real only(Mask m, Real x) { return _mm512_maskz_mov_pd(m.bits, x.v); }
    /// b where either is not a number.
    friend Real larger(Real a, Real b) { return _mm512_maskz_max_pd(all, a.v, b.v); }
    /// b where either is not a number.
    friend Real smaller(Real a, Real b) { return _mm512_maskz_min_pd(all, a.v, b.v); }
    friend Real absolute(Real a) { return _mm512_abs_pd(a.v); }
    friend Real square_root(Real x) { return _mm512_maskz_sqrt_pd(all, x.v); }
    /// Of x >= 0, to the last bit or two: a third of the bits as an integer is a third of the exponent and near the
    /// root, from where Halley's steps cube the error.
    friend Real cube_root(Real x) {
      constexpr double bits_of_one_times_two_thirds = 3071306043645493248.0;
      constexpr double least = 1e-290;  // numbers near underflow would take a hundred times as long
      const Real held = larger(x, Real(least));
      const Real third = fused(Real(_mm512_maskz_cvtepi64_pd(all, _mm512_castpd_si512(held.v))), Real(1.0 / 3),
                               Real(bits_of_one_times_two_thirds));
      Real y = _mm512_castsi512_pd(_mm512_maskz_cvtpd_epi64(all, third.v));
      for (int step = 0; step < 3; ++step) {
        const Real cube = y * y * y;
        y = y * (fused(Real(2.0), held, cube) / fused(Real(2.0), cube, held));
      }
      return only(Real(0.0) < x, y);
    }
    friend Real nearest_integer(Real a) {
      return _mm512_maskz_roundscale_pd(all, a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    }
    /// y (1 - e)^(-1/2) with e = 1 - x y^2 from the 14-bit estimate y, by the series up to e^3: what is left out is
    /// below the last bit. Several times faster than sqrt and divide.
    [[gnu::always_inline]] friend Real inverse_sqrt(Real x) {
      const Real y = _mm512_maskz_rsqrt14_pd(all, x.v);
      const Real e = _mm512_fnmadd_pd((x * y).v, y.v, Real(1.0).v);
      const Real series = fused(fused(Real(5.0 / 16), e, Real(3.0 / 8)), e, Real(0.5)) * e;
      return fused(series, y, y);
    }
    /// The 14-bit estimate, once refined.
    [[gnu::always_inline]] friend Real rough_reciprocal(Real x) {
      const Real y = _mm512_maskz_rcp14_pd(all, x.v);
      return fused(fused(-x, y, Real(1.0)), y, y);
    }
    friend double sum(Real x) {
      return ((x.v[0] + x.v[4]) + (x.v[2] + x.v[6])) + ((x.v[1] + x.v[5]) + (x.v[3] + x.v[7]));
    }
    friend double largest(Real x) {
      double most = x.v[0];
      for (int k = 1; k < width; ++k) most = most < x.v[k] ? x.v[k] : most;
      return most;
    }
  };

  static Real load(const double* p) { return _mm512_loadu_pd(p); }
  static void store(double* p, Real x) { _mm512_storeu_pd(p, x.v); }
  static double lane(Real x, int k) { return x.v[k]; }
  static Mask mask(std::uint32_t lanes) { return {static_cast<__mmask8>(lanes)}; }
  static Real gather(const double* table, const std::int32_t* index) {
    const auto at = [&](int k) { return table[index[k]]; };
    return _mm512_setr_pd(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
  }

  template <std::size_t stride>
  [[gnu::always_inline]] static void write_columns(double* rows, const Real* column) {
    const __m512d xy_even = _mm512_maskz_unpacklo_pd(all, column[0].v, column[1].v);
    const __m512d xy_odd = _mm512_maskz_unpackhi_pd(all, column[0].v, column[1].v);
    const __m512d zw_even = _mm512_maskz_unpacklo_pd(all, column[2].v, column[3].v);
    const __m512d zw_odd = _mm512_maskz_unpackhi_pd(all, column[2].v, column[3].v);
    const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11),
                  high = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
    const auto write = [&](int k, __m512d even_or_odd_rows) {
      _mm256_storeu_pd(rows + stride * k, __builtin_shufflevector(even_or_odd_rows, even_or_odd_rows, 0, 1, 2, 3));
      _mm256_storeu_pd(rows + stride * (k + 2), _mm512_maskz_extractf64x4_pd(all, even_or_odd_rows, 1));
    };
    write(0, _mm512_permutex2var_pd(xy_even, low, zw_even));
    write(1, _mm512_permutex2var_pd(xy_odd, low, zw_odd));
    write(4, _mm512_permutex2var_pd(xy_even, high, zw_even));
    write(5, _mm512_permutex2var_pd(xy_odd, high, zw_odd));
  }

  using Word = __m256;
  static Word narrowed(Real x) { return _mm512_maskz_cvtpd_ps(all, x.v); }
  static Word low_word(Real x) {
    return _mm256_castsi256_ps(_mm512_maskz_cvtepi64_epi32(all, _mm512_castpd_si512(x.v)));
  }
  template <std::size_t stride>
  [[gnu::always_inline]] static void write_words(float* rows, const Word* column) {
    const auto write = [&](std::size_t k, __m256d ab, __m256d cd, auto unpacked) {
      const __m256 two_rows = _mm256_castpd_ps(unpacked(ab, cd));
      _mm_storeu_ps(rows + stride * k, _mm256_castps256_ps128(two_rows));
      _mm_storeu_ps(rows + stride * (k + 4), _mm256_extractf128_ps(two_rows, 1));
    };
    const auto even = [](__m256d x, __m256d y) { return _mm256_unpacklo_pd(x, y); };
    const auto odd = [](__m256d x, __m256d y) { return _mm256_unpackhi_pd(x, y); };
    const __m256d ab = _mm256_castps_pd(_mm256_unpacklo_ps(column[0], column[1]));
    const __m256d cd = _mm256_castps_pd(_mm256_unpacklo_ps(column[2], column[3]));
    write(0, ab, cd, even);
    write(1, ab, cd, odd);
    const __m256d ab_end = _mm256_castps_pd(_mm256_unpackhi_ps(column[0], column[1]));
    const __m256d cd_end = _mm256_castps_pd(_mm256_unpackhi_ps(column[2], column[3]));
    write(2, ab_end, cd_end, even);
    write(3, ab_end, cd_end, odd);
  }

 private:
  friend struct ReadsColumns<Avx512, double>;

  /// Two half rows go into one register straight from memory, which spares a third
  /// of the shuffles of an 8 x 8 transpose; gather instructions are slower still.
  template <int columns, class RowAt>
  [[gnu::always_inline]] static void read(const RowAt& row, Real* column) {
    const auto two = [&](int a, int b) {
      return _mm512_maskz_insertf64x4(all, _mm512_castpd256_pd512(_mm256_loadu_pd(row(a))), _mm256_loadu_pd(row(b)), 1);
    };
    const __m512d a = two(0, 2), b = two(1, 3), c = two(4, 6), d = two(5, 7);
    const __m512d even_low = _mm512_maskz_unpacklo_pd(all, a, b), even_high = _mm512_maskz_unpacklo_pd(all, c, d);
    constexpr int lanes_0_2 = 0x88, lanes_1_3 = 0xdd;
    column[0].v = _mm512_maskz_shuffle_f64x2(all, even_low, even_high, lanes_0_2);
    if constexpr (columns > 2) column[2].v = _mm512_maskz_shuffle_f64x2(all, even_low, even_high, lanes_1_3);
    if constexpr (columns > 1) {
      const __m512d odd_low = _mm512_maskz_unpackhi_pd(all, a, b), odd_high = _mm512_maskz_unpackhi_pd(all, c, d);
      column[1].v = _mm512_maskz_shuffle_f64x2(all, odd_low, odd_high, lanes_0_2);
      if constexpr (columns > 3) column[3].v = _mm512_maskz_shuffle_f64x2(all, odd_low, odd_high, lanes_1_3);
    }
  }
};

}  // namespace packstone::engine::simd

#endif
