// What contacts keep from step to step, beside the rows of the neighbour list, and how it survives their rebuilding.
#pragma once

#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "engine/aligned_vector.hpp"
#include "engine/detection/neighbour_list.hpp"
#include "engine/detection/wall_list.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

/// Some numbers a lane and row. Those of contacts that did not touch in the step before are zero, and are kept so by a
/// bit rather than by writing zeros. How many there are the caller says each time: where it is a constant, so are all
/// places.
template <class Number>
class ContactMemory {
 public:
  void resize(std::int64_t rows, int width, int numbers) {
    width_ = width;
    const std::size_t count = static_cast<std::size_t>(rows) * width * numbers;
    if (values_.capacity() < count) {
      AlignedVector<Number>().swap(values_);  // before the larger store is there: they are the largest of all
      values_.reserve(count + count / spare_share);
    }
    values_.assign(count, Number(0));
    touched_.assign(static_cast<std::size_t>(rows), 0);
  }

  /// Numbers first..first + some of all, into the beginning of `to`.
  template <class Lanes, class Numbers>
  [[gnu::always_inline]] void load(std::int64_t row, int all, int first, int some, Numbers& to) const {
    using simd::only;
    const Number* at = &values_[index(row, all)];
    const typename Lanes::Mask touched = Lanes::mask(touched_[row]);
    for (int k = 0; k < some; ++k) to[k] = only(touched, Lanes::load(at + (first + k) * width_));
  }
  template <class Lanes, class Numbers>
  [[gnu::always_inline]] void store(std::int64_t row, int all, int first, int some, const Numbers& from) {
    Number* at = &values_[index(row, all)];
    for (int k = 0; k < some; ++k) Lanes::store(at + (first + k) * width_, from[k]);
  }
  template <class Lanes>
  [[gnu::always_inline]] void touch(std::int64_t row, typename Lanes::Mask touching) {
    using simd::bits;
    touched_[row] = static_cast<std::uint16_t>(bits(touching));
  }
  /// Asks for some rows ahead of their use.
  [[gnu::always_inline]] void prefetch(std::int64_t row, std::int64_t rows, int all) const {
    constexpr std::size_t line = 64 / sizeof(Number);
    const Number* at = values_.data() + index(row, all);
    const Number* const end = at + index(rows, all);
    for (; at < end; at += line) __builtin_prefetch(at, 1);
  }
  /// One contact is over.
  void forget(std::int64_t row, int lane) { touched_[row] = static_cast<std::uint16_t>(touched_[row] & ~(1u << lane)); }
  /// Nothing touches in this row.
  void none(std::int64_t row) {
    if (touched_[row] != 0) touched_[row] = 0;
  }

  void archive(Archive& a) { a(width_, values_, touched_); }

  int width() const { return width_; }
  bool touched(std::int64_t row, int lane) const { return (touched_[row] >> lane & 1u) != 0; }
  /// Of one contact, from and to a sequence of numbers.
  void get(std::int64_t row, int lane, int all, double* to) const {
    for (int k = 0; k < all; ++k) to[k] = values_[index(row, all) + k * width_ + lane];
  }
  void set(std::int64_t row, int lane, int all, const double* from) {
    for (int k = 0; k < all; ++k) values_[index(row, all) + k * width_ + lane] = static_cast<Number>(from[k]);
    touched_[row] = static_cast<std::uint16_t>(touched_[row] | 1u << lane);
  }

 private:
  static constexpr std::size_t spare_share = 32;  ///< lists differ in length

  std::size_t index(std::int64_t row, int all) const { return static_cast<std::size_t>(row) * width_ * all; }

  int width_ = 1;
  AlignedVector<Number> values_;        ///< (rows, numbers, width)
  std::vector<std::uint16_t> touched_;  ///< a bit a lane
};

/// What contacts that touch keep, by particle id, free of the list's layout.
struct StoredContacts {
  std::vector<std::int64_t> end;      ///< of each particle's contacts, by id
  std::vector<std::int64_t> partner;  ///< of each contact: id, or -1-k for a piece of a boundary with the key k
  std::vector<double> numbers;        ///< (contacts, numbers of one)
};

/// Number: of the forces between particles.
template <class Number>
struct ContactHistory {
  int numbers = 0;              ///< that a contact keeps
  ContactMemory<Number> pairs;  ///< rows of the list
  ContactMemory<double> walls;  ///< rows of the wall list

  StoredContacts store(const NeighbourList& list, const WallList& wall_list, const Particles& particles) const;
  void restore(const StoredContacts& stored, const NeighbourList& list, const WallList& wall_list,
               const Particles& particles);
};

}  // namespace packstone::engine
