// The widest lanes that this build may use.
#pragma once

#include "engine/simd/avx2.hpp"
#include "engine/simd/avx512.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine::simd {

#if defined(PACKSTONE_AVX512)
using Widest = Avx512;
#elif defined(PACKSTONE_AVX2)
using Widest = Avx2;
#else
using Widest = Scalar;
#endif

}  // namespace packstone::engine::simd
