// Random numbers with names: a draw depends on (seed, stream, index, draw) alone, never on threads or on order.
// Generator: Philox 4x32-10, Salmon, Moraes, Dror, Shaw, Proc. SC'11 (2011). The distributions are our own, since those
// of the standard library differ from one implementation to the next.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace packstone {

/// Every use of random numbers has a stream of its own; numbers are never reused for another purpose.
enum class RandomStream : std::uint32_t {
  filling_position = 1,
  particle_radius = 2,
  label_permutation = 3,
  filling_order = 4,
  reference_sample = 5,
  pore_point = 6,
  shell_direction = 7,
  followed_particles = 8,
  fraction_estimate = 9,
};

/// A sequence of draws for one item (a particle, a trial) of one stream.
class Random {
 public:
  Random(std::uint64_t seed, RandomStream stream, std::uint64_t index);

  std::uint32_t bits();
  /// In [0, 1), 53 random bits.
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, n), n > 0, without bias.
  std::uint32_t below(std::uint32_t n);

 private:
  void refill();

  std::uint32_t key_[2];
  std::uint32_t counter_[4];
  std::uint32_t block_[4] = {};
  int used_ = 4;
};

/// Puts values into random order, each order as likely (Fisher & Yates).
template <class Value>
void shuffle(std::vector<Value>& values, Random& random) {
  for (std::size_t k = values.size(); k > 1; --k) {
    std::swap(values[k - 1], values[random.below(static_cast<std::uint32_t>(k))]);
  }
}

}  // namespace packstone
