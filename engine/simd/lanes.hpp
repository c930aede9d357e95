// The widest lanes that this build may use.
#pragma once

#include "engine/simd/avx2_single.hpp"
#include "engine/simd/avx512_single.hpp"
#include "engine/simd/scalar_single.hpp"

namespace packstone::engine::simd {

#if defined(PACKSTONE_AVX512)
using Widest = Avx512;
using WidestSingle = Avx512Single;
#elif defined(PACKSTONE_AVX2)
using Widest = Avx2;
using WidestSingle = Avx2Single;
#else
using Widest = Scalar;
using WidestSingle = ScalarSingle;
#endif

}  // namespace packstone::engine::simd
