// Eight lanes of single precision in AVX2 registers with fused multiply-add. See scalar.hpp and scalar_single.hpp for
// what each operation means.
#pragma once

#include "engine/simd/avx2.hpp"

#ifdef PACKSTONE_AVX2

namespace packstone::engine::simd {

struct Avx2Single : ReadsColumns<Avx2Single, float> {
  using Whole = Avx2;
  static constexpr int width = 8;
  static constexpr const char* name = "AVX2, single precision";

  struct Mask {
    __m256 lanes;  ///< all bits of a lane set or none

    friend Mask operator&(Mask a, Mask b) { return {_mm256_and_ps(a.lanes, b.lanes)}; }
    friend Mask operator|(Mask a, Mask b) { return {_mm256_or_ps(a.lanes, b.lanes)}; }
    friend bool any(Mask m) { return _mm256_movemask_ps(m.lanes) != 0; }
    friend std::uint32_t bits(Mask m) { return static_cast<std::uint32_t>(_mm256_movemask_ps(m.lanes)); }
  };

  struct Real : Arithmetic<Real> {
    __m256 v;

    Real() = default;
    Real(double x) : v(_mm256_set1_ps(static_cast<float>(x))) {}
    Real(__m256 x) : v(x) {}

    friend Mask operator<(Real a, Real b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
    friend Mask operator>(Real a, Real b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)}; }

    friend Real fused(Real a, Real b, Real c) { return _mm256_fmadd_ps(a.v, b.v, c.v); }
    friend Real fused_where(Mask m, Real a, Real b, Real c) { return select(m, fused(a, b, c), c); }
    friend Real select(Mask m, Real yes, Real no) { return _mm256_blendv_ps(no.v, yes.v, m.lanes); }
    friend Real only(Mask m, Real x) { return _mm256_and_ps(m.lanes, x.v); }
    /// b where either is not a number.
    friend Real larger(Real a, Real b) { return _mm256_max_ps(a.v, b.v); }
    /// b where either is not a number.
    friend Real smaller(Real a, Real b) { return _mm256_min_ps(a.v, b.v); }
    friend Real square_root(Real x) { return _mm256_sqrt_ps(x.v); }
    friend Real cube_root(Real x) {
      for (int k = 0; k < width; ++k) x.v[k] = std::cbrt(x.v[k]);
      return x;
    }
    friend Real absolute(Real a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v); }
    friend Real nearest_integer(Real a) { return _mm256_round_ps(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }
    friend Real inverse_sqrt(Real x) { return Real(1.0) / Real(_mm256_sqrt_ps(x.v)); }
    friend Real rough_reciprocal(Real x) { return Real(1.0) / x; }
    friend double sum(Real x) { return sum(widened(x, 0) + widened(x, 1)); }
  };

  static double lane(Real x, int k) { return x.v[k]; }
  static Mask mask(std::uint32_t lanes) {
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i chosen = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(lanes)), bit);
    return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(chosen, bit))};
  }
  static Real load(const float* p) { return _mm256_loadu_ps(p); }
  static void store(float* p, Real x) { _mm256_storeu_ps(p, x.v); }
  static Real gather(const double* table, const std::int32_t* index) {
    const auto at = [&](int k) { return static_cast<float>(table[index[k]]); };
    return _mm256_setr_ps(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
  }

  static Whole::Real widened(Real x, int part) {
    return _mm256_cvtps_pd(part == 0 ? _mm256_castps256_ps128(x.v) : _mm256_extractf128_ps(x.v, 1));
  }
  static Real difference_of_places(Real a, Real b) {
    return _mm256_cvtepi32_ps(_mm256_sub_epi32(_mm256_castps_si256(a.v), _mm256_castps_si256(b.v)));
  }

  static int write_indices(Mask mask, std::int32_t first, std::int32_t* to) {
    int count = 0;
    for (std::uint32_t lanes = bits(mask); lanes != 0; lanes &= lanes - 1)
      to[count++] = first + std::countr_zero(lanes);
    return count;
  }

 private:
  friend struct ReadsColumns<Avx2Single, float>;

  template <int columns, class RowAt>
  [[gnu::always_inline]] static void read(const RowAt& row, Real* column) {
    const auto two = [&](int k) {
      return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(row(k))), _mm_loadu_ps(row(k + 4)), 1);
    };
    const __m256 a = two(0), b = two(1), c = two(2), d = two(3);
    const auto low = [](__m256 x, __m256 y) { return _mm256_castps_pd(_mm256_unpacklo_ps(x, y)); };
    const auto high = [](__m256 x, __m256 y) { return _mm256_castps_pd(_mm256_unpackhi_ps(x, y)); };
    const __m256d ab = low(a, b), cd = low(c, d), ab_end = high(a, b), cd_end = high(c, d);
    column[0].v = _mm256_castpd_ps(_mm256_unpacklo_pd(ab, cd));
    column[1].v = _mm256_castpd_ps(_mm256_unpackhi_pd(ab, cd));
    column[2].v = _mm256_castpd_ps(_mm256_unpacklo_pd(ab_end, cd_end));
    if constexpr (columns > 3) column[3].v = _mm256_castpd_ps(_mm256_unpackhi_pd(ab_end, cd_end));
  }
};

}  // namespace packstone::engine::simd

#endif
