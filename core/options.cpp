#include "core/options.hpp"

#include <cmath>

#include <fmt/format.h>

namespace packstone {

std::string Range::text() const {
  const bool bounded_below = std::isfinite(low), bounded_above = std::isfinite(high);
  if (bounded_below && bounded_above) {
    return fmt::format("from {}{:g} to {}{:g}", low_included ? "" : "above ", low, high_included ? "" : "below ", high);
  }
  if (bounded_below) return fmt::format("{} {:g}", low_included ? "at least" : "greater than", low);
  if (bounded_above) return fmt::format("{} {:g}", high_included ? "at most" : "less than", high);
  return "";
}

}  // namespace packstone
