// Rows of values in another order.
#pragma once

#include <cstddef>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone {

/// The values of these rows, in that order; none where there are none, of a column that was not read.
template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> result;
  if (values.empty()) return result;
  result.reserve(values.size());
  for (std::size_t row : order) result.push_back(values[row]);
  return result;
}

inline Field reordered(const Field& field, const std::vector<std::size_t>& order) {
  Field result{field.components, field.unit, {}};
  result.values.reserve(field.values.size());
  for (std::size_t row : order) {
    const auto from = field.values.begin() + static_cast<std::ptrdiff_t>(row * field.components);
    result.values.insert(result.values.end(), from, from + field.components);
  }
  return result;
}

}  // namespace packstone
