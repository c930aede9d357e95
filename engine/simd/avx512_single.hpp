// Sixteen lanes of single precision in AVX-512 registers (F, DQ, VL). See scalar.hpp and scalar_single.hpp for what
// each operation means.
#pragma once

#include "engine/simd/avx512.hpp"

#ifdef PACKSTONE_AVX512

namespace packstone::engine::simd {

struct Avx512Single : ReadsColumns<Avx512Single, float> {
  using Whole = Avx512;
  static constexpr int width = 16;
  static constexpr const char* name = "AVX-512, single precision";

  static constexpr __mmask16 all = 0xffff;  ///< as in Avx512

  struct Mask {
    __mmask16 bits = 0;

    friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask16>(a.bits & b.bits)}; }
    friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask16>(a.bits | b.bits)}; }
    friend bool any(Mask m) { return m.bits != 0; }
    friend std::uint32_t bits(Mask m) { return m.bits; }
  };

  struct Real : Arithmetic<Real> {
    __m512 v;

    Real() = default;
    Real(double x) : v(_mm512_set1_ps(static_cast<float>(x))) {}
    Real(__m512 x) : v(x) {}

    friend Mask operator<(Real a, Real b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)}; }
    friend Mask operator>(Real a, Real b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)}; }

    friend Real fused(Real a, Real b, Real c) { return _mm512_fmadd_ps(a.v, b.v, c.v); }
    friend Real fused_where(Mask m, Real a, Real b, Real c) { return _mm512_mask3_fmadd_ps(a.v, b.v, c.v, m.bits); }
    friend Real select(Mask m, Real yes, Real no) { return _mm512_mask_blend_ps(m.bits, no.v, yes.v); }
    friend Real only(Mask m, Real x) { return _mm512_maskz_mov_ps(m.bits, x.v); }
    /// b where either is not a number.
    friend Real larger(Real a, Real b) { return _mm512_maskz_max_ps(all, a.v, b.v); }
    /// b where either is not a number.
    friend Real smaller(Real a, Real b) { return _mm512_maskz_min_ps(all, a.v, b.v); }
    friend Real absolute(Real a) { return _mm512_abs_ps(a.v); }
    friend Real square_root(Real x) { return _mm512_maskz_sqrt_ps(all, x.v); }
    /// As in Avx512.
    friend Real cube_root(Real x) {
      constexpr double bits_of_one_times_two_thirds = 709958130.0, least = 1e-30;
      const Real held = larger(x, Real(least));
      const Real third = fused(Real(_mm512_maskz_cvtepi32_ps(all, _mm512_castps_si512(held.v))), Real(1.0 / 3),
                               Real(bits_of_one_times_two_thirds));
      Real y = _mm512_castsi512_ps(_mm512_maskz_cvtps_epi32(all, third.v));
      for (int step = 0; step < 2; ++step) {
        const Real cube = y * y * y;
        y = y * (fused(Real(2.0), held, cube) / fused(Real(2.0), cube, held));
      }
      return only(Real(0.0) < x, y);
    }
    friend Real nearest_integer(Real a) {
      return _mm512_maskz_roundscale_ps(all, a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    }
    /// The 14-bit estimate, once refined.
    [[gnu::always_inline]] friend Real inverse_sqrt(Real x) {
      const Real y = _mm512_maskz_rsqrt14_ps(all, x.v);
      const Real e = _mm512_fnmadd_ps((x * y).v, y.v, Real(1.0).v);
      return fused(Real(0.5) * e, y, y);
    }
    friend Real rough_reciprocal(Real x) { return _mm512_maskz_rcp14_ps(all, x.v); }
    friend double sum(Real x) { return sum(widened(x, 0) + widened(x, 1)); }
  };

  static double lane(Real x, int k) { return x.v[k]; }
  static Mask mask(std::uint32_t lanes) { return {static_cast<__mmask16>(lanes)}; }
  static Real load(const float* p) { return _mm512_loadu_ps(p); }
  static void store(float* p, Real x) { _mm512_storeu_ps(p, x.v); }
  static Real gather(const double* table, const std::int32_t* index) {
    Real x;
    for (int k = 0; k < width; ++k) x.v[k] = static_cast<float>(table[index[k]]);
    return x;
  }

  static Whole::Real widened(Real x, int part) {
    const __m256 half =
        part == 0 ? _mm512_maskz_extractf32x8_ps(Whole::all, x.v, 0) : _mm512_maskz_extractf32x8_ps(Whole::all, x.v, 1);
    return _mm512_maskz_cvtps_pd(Whole::all, half);
  }
  static Real difference_of_places(Real a, Real b) {
    return _mm512_maskz_cvtepi32_ps(all, _mm512_sub_epi32(_mm512_castps_si512(a.v), _mm512_castps_si512(b.v)));
  }

  static int write_indices(Mask mask, std::int32_t first, std::int32_t* to) {
    const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m512i index = _mm512_add_epi32(_mm512_set1_epi32(first), lane);
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask.bits, index));
    return std::popcount(mask.bits);
  }

 private:
  friend struct ReadsColumns<Avx512Single, float>;

  /// Four rows go into one register straight from memory, so that a transpose within quarters of it is enough.
  template <int columns, class RowAt>
  [[gnu::always_inline]] static void read(const RowAt& row, Real* column) {
    const auto four = [&](int k) {
      __m512 rows = _mm512_castps128_ps512(_mm_loadu_ps(row(k)));
      rows = _mm512_maskz_insertf32x4(all, rows, _mm_loadu_ps(row(k + 4)), 1);
      rows = _mm512_maskz_insertf32x4(all, rows, _mm_loadu_ps(row(k + 8)), 2);
      return _mm512_maskz_insertf32x4(all, rows, _mm_loadu_ps(row(k + 12)), 3);
    };
    const __m512 a = four(0), b = four(1), c = four(2), d = four(3);
    const auto low = [](__m512 x, __m512 y) { return _mm512_castps_pd(_mm512_maskz_unpacklo_ps(all, x, y)); };
    const auto high = [](__m512 x, __m512 y) { return _mm512_castps_pd(_mm512_maskz_unpackhi_ps(all, x, y)); };
    const __m512d ab = low(a, b), cd = low(c, d);
    column[0].v = _mm512_castpd_ps(_mm512_maskz_unpacklo_pd(Whole::all, ab, cd));
    column[1].v = _mm512_castpd_ps(_mm512_maskz_unpackhi_pd(Whole::all, ab, cd));
    const __m512d ab_end = high(a, b), cd_end = high(c, d);
    column[2].v = _mm512_castpd_ps(_mm512_maskz_unpacklo_pd(Whole::all, ab_end, cd_end));
    if constexpr (columns > 3) column[3].v = _mm512_castpd_ps(_mm512_maskz_unpackhi_pd(Whole::all, ab_end, cd_end));
  }
};

}  // namespace packstone::engine::simd

#endif
