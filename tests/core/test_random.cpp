#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/random.hpp"

using namespace packstone;

TEST_CASE("the generator gives Philox 4x32-10's published numbers") {
  // Known answers of the Random123 distribution (kat_vectors), counter and key zero.
  Random random(0, static_cast<RandomStream>(0), 0);
  CHECK(random.bits() == 0x6627e8d5u);
  CHECK(random.bits() == 0xe169c58du);
  CHECK(random.bits() == 0xbc57ac4cu);
  CHECK(random.bits() == 0x9b00dbd8u);
}

TEST_CASE("the generator gives Philox's published numbers for a counter and key of all ones") {
  Random random(~0ull, static_cast<RandomStream>(~0u), ~0ull);
  // The counter's first word starts at zero; the known answer has it at all ones, 2^32 - 1 blocks on, so compare a
  // further draw with an independent evaluation of the same round function instead.
  std::array<std::uint32_t, 4> c = {0, ~0u, ~0u, ~0u};
  std::array<std::uint32_t, 2> k = {~0u, ~0u};
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p0 = 0xD2511F53ull * c[0], p1 = 0xCD9E8D57ull * c[2];
    c = {std::uint32_t(p1 >> 32) ^ c[1] ^ k[0], std::uint32_t(p1), std::uint32_t(p0 >> 32) ^ c[3] ^ k[1],
         std::uint32_t(p0)};
    k = {k[0] + 0x9E3779B9u, k[1] + 0xBB67AE85u};
  }
  for (const std::uint32_t word : c) CHECK(random.bits() == word);
}

TEST_CASE("streams and indices are independent, a draw depends on nothing else") {
  const auto first = [](std::uint64_t seed, RandomStream stream, std::uint64_t index) {
    return Random(seed, stream, index).bits();
  };
  const auto reference = first(1, RandomStream::filling_position, 7);
  CHECK(first(1, RandomStream::filling_position, 7) == reference);
  CHECK(first(2, RandomStream::filling_position, 7) != reference);
  CHECK(first(1, RandomStream::particle_radius, 7) != reference);
  CHECK(first(1, RandomStream::filling_position, 8) != reference);
}

TEST_CASE("uniform numbers have the mean, variance and range of the uniform distribution") {
  constexpr int count = 200000;
  Random random(3, RandomStream::label_permutation, 0);
  double sum = 0, squares = 0;
  for (int k = 0; k < count; ++k) {
    const double u = random.uniform();
    REQUIRE((u >= 0 && u < 1));
    sum += u;
    squares += u * u;
  }
  const double mean = sum / count, five_sigma = 5 / std::sqrt(12.0 * count);
  CHECK(std::abs(mean - 0.5) < five_sigma);
  CHECK(std::abs(squares / count - mean * mean - 1.0 / 12) < five_sigma);
}

TEST_CASE("whole numbers below n are equally likely") {
  constexpr std::uint32_t n = 7;
  constexpr int count = 140000;
  std::array<int, n> hits{};
  Random random(5, RandomStream::label_permutation, 1);
  for (int k = 0; k < count; ++k) {
    const auto value = random.below(n);
    REQUIRE(value < n);
    ++hits[value];
  }
  double chi_squared = 0;
  const double expected = static_cast<double>(count) / n;
  for (const int hit : hits) chi_squared += (hit - expected) * (hit - expected) / expected;
  CHECK(chi_squared < 27.9);  // 6 degrees of freedom, p = 1e-4
}
