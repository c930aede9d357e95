#include "core/random.hpp"

namespace packstone {

namespace {

constexpr std::uint32_t philox_multiplier[2] = {0xD2511F53u, 0xCD9E8D57u};
constexpr std::uint32_t weyl_increment[2] = {0x9E3779B9u, 0xBB67AE85u};
constexpr int philox_rounds = 10;

}  // namespace

Random::Random(std::uint64_t seed, RandomStream stream, std::uint64_t index)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
      counter_{0, static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(index),
               static_cast<std::uint32_t>(index >> 32)} {}

void Random::refill() {
  std::uint32_t c[4] = {counter_[0], counter_[1], counter_[2], counter_[3]};
  std::uint32_t k[2] = {key_[0], key_[1]};
  for (int round = 0; round < philox_rounds; ++round) {
    const std::uint64_t a = std::uint64_t{philox_multiplier[0]} * c[0];
    const std::uint64_t b = std::uint64_t{philox_multiplier[1]} * c[2];
    const std::uint32_t next[4] = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ k[0], static_cast<std::uint32_t>(b),
                                   static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ k[1], static_cast<std::uint32_t>(a)};
    for (int i = 0; i < 4; ++i) c[i] = next[i];
    for (int i = 0; i < 2; ++i) k[i] += weyl_increment[i];
  }
  for (int i = 0; i < 4; ++i) block_[i] = c[i];
  ++counter_[0];
  used_ = 0;
}

std::uint32_t Random::bits() {
  if (used_ == 4) refill();
  return block_[used_++];
}

double Random::uniform() {
  const std::uint64_t high = bits() >> 5;  // 27 bits
  const std::uint64_t low = bits() >> 6;   // 26 bits
  return static_cast<double>((high << 26) | low) * 0x1p-53;
}

std::uint32_t Random::below(std::uint32_t n) {
  const std::uint32_t unfair = (0u - n) % n;  // 2^32 mod n values at the low end would be drawn once too often
  std::uint64_t product;
  do {
    product = std::uint64_t{bits()} * n;
  } while (static_cast<std::uint32_t>(product) < unfair);
  return static_cast<std::uint32_t>(product >> 32);
}

}  // namespace packstone
