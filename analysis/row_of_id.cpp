#include "analysis/row_of_id.hpp"

#include <algorithm>
#include <string>

#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr std::uint64_t most_slots_a_particle = 4;  // of a table: ids farther apart are sorted instead

}  // namespace

RowOfId::RowOfId(std::span<const std::int64_t> id) {
  if (id.empty()) return;
  const auto [lowest, highest] = std::minmax_element(id.begin(), id.end());
  lowest_ = *lowest;
  const std::uint64_t extent = static_cast<std::uint64_t>(*highest) - static_cast<std::uint64_t>(*lowest);
  if (extent < most_slots_a_particle * id.size()) {
    table_.assign(extent + 1, no_row);
    for (std::size_t i = 0; i < id.size(); ++i) {
      table_[static_cast<std::size_t>(id[i] - lowest_)] = static_cast<std::uint32_t>(i);
    }
    return;
  }
  sorted_.reserve(id.size());
  for (std::size_t i = 0; i < id.size(); ++i) sorted_.push_back({id[i], static_cast<std::uint32_t>(i)});
  std::sort(sorted_.begin(), sorted_.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
}

std::uint32_t RowOfId::find(std::int64_t id) const {
  if (!table_.empty()) {
    const std::uint64_t slot = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(lowest_);
    return id >= lowest_ && slot < table_.size() ? table_[slot] : no_row;
  }
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), id,
                                      [](const Entry& entry, std::int64_t wanted) { return entry.id < wanted; });
  return found != sorted_.end() && found->id == id ? found->row : no_row;
}

std::uint32_t RowOfId::at(std::int64_t id) const {
  const std::uint32_t row = find(id);
  if (row != no_row) return row;
  throw InputError("a contact names particle " + std::to_string(id) +
                   ", which the snapshot does not hold; read the snapshot whole");
}

}  // namespace packstone::analysis
