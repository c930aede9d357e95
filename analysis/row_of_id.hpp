// Rows of particles by their id.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace packstone::analysis {

/// Finds the row of an id: by a table where the ids lie close together, else by bisection.
class RowOfId {
 public:
  /// id: (N), at most 2^32 - 1.
  explicit RowOfId(std::span<const std::int64_t> id);

  static constexpr std::uint32_t no_row = std::numeric_limits<std::uint32_t>::max();

  /// no_row for an id that no row has.
  std::uint32_t find(std::int64_t id) const;

  /// Throws InputError for an id that no row has: a contact names it.
  std::uint32_t at(std::int64_t id) const;

 private:
  struct Entry {
    std::int64_t id;
    std::uint32_t row;
  };

  std::int64_t lowest_ = 0;
  std::vector<std::uint32_t> table_;  ///< row of lowest_ + k; empty where the ids are scattered
  std::vector<Entry> sorted_;         ///< where they are
};

}  // namespace packstone::analysis
