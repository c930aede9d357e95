#include "engine/dynamics/contact_matrix.hpp"

#include <algorithm>
#include <cmath>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// A slot of the matrix takes as long as a fraction of one of the forces.
constexpr std::size_t entries_as_light = 4;

/// use(slot, first entry, end of entries) for each slot of each block, blocks side by side.
template <class Blocks, class Use>
void for_each_slot(const Blocks& blocks, std::size_t slots, const Use& use) {
  const auto count = static_cast<std::ptrdiff_t>(blocks.size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(slots / entries_as_light))
  for (std::ptrdiff_t b = 0; b < count; ++b) {
    const ContactMatrix::Entry* entry = blocks[b].entries.data();
    const ContactMatrix::Entry* const first = entry;
    for (const auto& [slot, end] : blocks[b].ends) {
      use(b, slot, entry, first + end);
      entry = first + end;
    }
  }
}

}  // namespace

void ContactMatrix::multiply(const std::vector<double>& mobility, double share, const SlotVectors& x,
                             SlotVectors& y) const {
  for_each_slot(blocks_, x.size(), [&](std::ptrdiff_t, std::int32_t slot, const Entry* entry, const Entry* end) {
    const Vec3 own = x[slot];
    Vec3 sum = share / mobility[slot] * own;
    for (; entry != end; ++entry) {
      const Vec3 d = entry->other == wall ? own : Vec3(own - x[entry->other]);
      sum += entry->stiffness * entry->normal.dot(d) * entry->normal;
    }
    y[slot] = sum;
  });
}

void ContactMatrix::invert_diagonal(const std::vector<double>& mobility, double share,
                                    std::vector<Mat3>& inverse) const {
  inverse.resize(mobility.size());
  for_each_slot(blocks_, mobility.size(), [&](std::ptrdiff_t, std::int32_t slot, const Entry* entry, const Entry* end) {
    Mat3 sum = Mat3::Identity() * (share / mobility[slot]);
    for (; entry != end; ++entry) sum += entry->stiffness * entry->normal * entry->normal.transpose();
    inverse[slot] = sum.inverse();
  });
}

double ContactMatrix::energy() const {
  double sum = 0;
  for (const Block& block : blocks_) sum += block.energy;
  return sum;
}

double ContactMatrix::largest_rate(const std::vector<double>& mobility) const {
  std::vector<double> largest(blocks_.size(), 0.0);
  for_each_slot(blocks_, mobility.size(),
                [&](std::ptrdiff_t block, std::int32_t slot, const Entry* entry, const Entry* end) {
                  double sum = 0;
                  for (; entry != end; ++entry) {
                    // Scaled by roots of mobilities the matrix is symmetric: its row sums.
                    const double own = mobility[slot];
                    const double other = entry->other == wall ? 0 : std::sqrt(own * mobility[entry->other]);
                    sum += entry->stiffness * (own + other);
                  }
                  largest[block] = std::max(largest[block], sum);
                });
  return largest.empty() ? 0 : *std::max_element(largest.begin(), largest.end());
}

}  // namespace packstone::engine
