// How bright a surface is, for all bodies that are drawn ray by ray.
#pragma once

#include <bit>
#include <cstdint>

namespace packstone::viz {

// By value: std::min and std::max keep the compiler from vectorising.
inline float lesser(float a, float b) { return a < b ? a : b; }
inline float greater(float a, float b) { return a > b ? a : b; }

/// Lights that go with the viewer: one beside him, the key light over the left shoulder, a weak one from the right; a
/// small highlight from the key light. The normal's components are to the right, down, and away from the viewer.
inline std::uint32_t lit(float diffuse_r, float diffuse_g, float diffuse_b, float nx, float ny, float nz) {
  const float facing = greater(-nz, 0.0F);
  const float key = greater(-0.48F * nx - 0.69F * ny - 0.55F * nz, 0.0F);
  const float fill = greater(0.91F * nx - 0.18F * ny - 0.37F * nz, 0.0F);
  const float light = 0.22F + 0.36F * facing + 0.51F * key + 0.12F * fill;
  // From there on the power leaves no trace in a byte; smaller ones would be denormal, on which processors take their
  // time. As integers, since compilers move a choice of floats behind the power.
  constexpr auto faintest = std::bit_cast<std::int32_t>(0.125F);
  const auto towards_key = std::bit_cast<std::int32_t>(-0.27F * nx - 0.39F * ny - 0.88F * nz);
  float shine = std::bit_cast<float>(towards_key > faintest ? towards_key : faintest);
  for (int k = 0; k < 5; ++k) shine *= shine;
  constexpr float full = 255, opaque = 0xff;
  const float gloss = 0.10F * full * shine + 0.5F;  // rounds
  const auto tone = [&](float diffuse) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(lesser(diffuse * light + gloss, full)));
  };
  return tone(diffuse_r) | tone(diffuse_g) << 8 | tone(diffuse_b) << 16 | static_cast<std::uint32_t>(opaque) << 24;
}

}  // namespace packstone::viz
