// Tangential springs of contacts, beside the rows of the neighbour list, and how they survive its rebuilding.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/aligned_vector.hpp"
#include "engine/detection/neighbour_list.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// One spring a lane and row [m]. Springs of contacts that did not touch in the step before are zero, and are kept so
/// by a bit rather than by writing zeros.
template <class Number>
class Springs {
 public:
  void resize(std::int64_t rows, int width) {
    width_ = width;
    const std::size_t count = static_cast<std::size_t>(rows) * width * 3;
    if (values_.capacity() < count) {
      AlignedVector<Number>().swap(values_);  // before the larger store is there: they are the largest of all
      values_.reserve(count + count / spare_share);
    }
    values_.assign(count, Number(0));
    touched_.assign(static_cast<std::size_t>(rows), 0);
  }

  template <class Lanes>
  simd::Vector<typename Lanes::Real> load(std::int64_t row) const {
    using simd::only;
    const Number* at = &values_[index(row)];
    const simd::Vector<typename Lanes::Real> spring{Lanes::load(at), Lanes::load(at + width_),
                                                    Lanes::load(at + 2 * width_)};
    return only(Lanes::mask(touched_[row]), spring);
  }
  template <class Lanes>
  void store(std::int64_t row, typename Lanes::Mask touching, const simd::Vector<typename Lanes::Real>& spring) {
    using simd::bits;
    Number* at = &values_[index(row)];
    Lanes::store(at, spring.x);
    Lanes::store(at + width_, spring.y);
    Lanes::store(at + 2 * width_, spring.z);
    touched_[row] = static_cast<std::uint16_t>(bits(touching));
  }
  /// Asks for some rows ahead of their use.
  [[gnu::always_inline]] void prefetch(std::int64_t row, std::int64_t rows) const {
    constexpr std::size_t line = 64 / sizeof(Number);
    const Number* at = &values_[index(row)];
    const Number* const end = at + index(rows);
    for (; at < end; at += line) __builtin_prefetch(at, 1);
  }
  /// Nothing touches in this row.
  void none(std::int64_t row) {
    if (touched_[row] != 0) touched_[row] = 0;
  }

  int width() const { return width_; }
  bool touched(std::int64_t row, int lane) const { return (touched_[row] >> lane & 1u) != 0; }
  Vec3 get(std::int64_t row, int lane) const {
    const Number* at = &values_[index(row) + lane];
    return {at[0], at[width_], at[2 * width_]};
  }
  void set(std::int64_t row, int lane, const Vec3& spring) {
    Number* at = &values_[index(row) + lane];
    for (int axis = 0; axis < 3; ++axis) at[axis * width_] = static_cast<Number>(spring[axis]);
    touched_[row] = static_cast<std::uint16_t>(touched_[row] | 1u << lane);
  }

 private:
  static constexpr std::size_t spare_share = 32;  ///< lists differ in length

  std::size_t index(std::int64_t row) const { return static_cast<std::size_t>(row) * width_ * 3; }

  int width_ = 1;
  AlignedVector<Number> values_;        ///< (rows, 3, width)
  std::vector<std::uint16_t> touched_;  ///< a bit a lane
};

/// Springs in contact by particle id, free of the list's layout.
struct StoredContacts {
  struct Contact {
    std::int64_t partner;  ///< id, or -1-k for boundary k
    Vec3 spring;
  };
  std::vector<std::int64_t> end;  ///< of each particle's contacts, by id
  std::vector<Contact> contacts;
};

/// Number: of the forces between particles.
template <class Number>
struct ContactHistory {
  Springs<Number> pairs;  ///< rows of the list
  Springs<double> walls;  ///< boundary by boundary, group by group, in rows of as many lanes as motion has

  StoredContacts store(const NeighbourList& list, const Particles& particles, std::size_t boundaries) const;
  /// wall_width: lanes of motion, which go into the list's a whole number of times.
  void restore(const StoredContacts& stored, const NeighbourList& list, const Particles& particles,
               std::size_t boundaries, int wall_width);
};

}  // namespace packstone::engine
