#include "analysis/result.hpp"

#include <algorithm>
#include <utility>

namespace packstone::analysis {

namespace {

template <class T>
const T* with_key(const std::vector<T>& items, std::string_view key) {
  const auto found = std::find_if(items.begin(), items.end(), [&](const T& item) { return item.key == key; });
  return found == items.end() ? nullptr : &*found;
}

}  // namespace

const Quantity* MeasureResult::quantity(std::string_view key) const { return with_key(quantities, key); }

const Table* MeasureResult::table(std::string_view key) const { return with_key(tables, key); }

Quantity not_applicable(Quantity quantity, std::string reason) {
  quantity.value.reset();
  quantity.uncertainty.reset();
  quantity.note = std::move(reason);
  return quantity;
}

}  // namespace packstone::analysis
