#include "core/units.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone {

namespace {

struct Factor {
  double scale;
  Dimension dimension;
};

/// Units that take metric prefixes.
const std::map<std::string_view, Factor> base_units = {
    {"m", {1, {1, 0, 0}}},    {"g", {1e-3, {0, 1, 0}}}, {"s", {1, {0, 0, 1}}},  {"N", {1, {1, 1, -2}}},
    {"Pa", {1, {-1, 1, -2}}}, {"J", {1, {2, 1, -2}}},   {"W", {1, {2, 1, -3}}}, {"Hz", {1, {0, 0, -1}}},
};

/// Units that do not.
const std::map<std::string_view, Factor> plain_units = {
    {"min", {60, {0, 0, 1}}}, {"h", {3600, {0, 0, 1}}}, {"deg", {std::numbers::pi / 180, {}}},
    {"rad", {1, {}}},         {"%", {0.01, {}}},        {"t", {1000, {0, 1, 0}}},
};

const std::map<std::string_view, double> prefixes = {
    {"n", 1e-9}, {"u", 1e-6}, {"\u00b5", 1e-6}, {"\u03bc", 1e-6}, {"m", 1e-3},
    {"c", 1e-2}, {"d", 1e-1}, {"k", 1e3},       {"M", 1e6},       {"G", 1e9},
};

std::optional<Factor> named_unit(std::string_view name) {
  if (const auto found = plain_units.find(name); found != plain_units.end()) return found->second;
  if (const auto found = base_units.find(name); found != base_units.end()) return found->second;
  for (const auto& [prefix, scale] : prefixes) {
    if (!name.starts_with(prefix)) continue;
    const auto found = base_units.find(name.substr(prefix.size()));
    if (found != base_units.end()) return Factor{scale * found->second.scale, found->second.dimension};
  }
  return std::nullopt;
}

constexpr int largest_power = 9;  ///< of a unit that means something; their sums must not overflow

/// "m3", "s^2", "kg": a name and an optional power.
std::optional<Factor> unit_power(std::string_view word) {
  const std::size_t name_end = word.find_first_of("^0123456789-");
  const auto unit = named_unit(word.substr(0, name_end));
  if (!unit) return std::nullopt;
  if (name_end == std::string_view::npos) return unit;
  std::string_view digits = word.substr(name_end);
  if (digits.starts_with('^')) digits.remove_prefix(1);
  int power = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), power);
  if (error != std::errc() || end != digits.end()) return std::nullopt;
  if (power < -largest_power || power > largest_power) return std::nullopt;
  return Factor{std::pow(unit->scale, power),
                {unit->dimension.length * power, unit->dimension.mass * power, unit->dimension.time * power}};
}

/// A product of powers, "N s/m": everything after a slash divides, until the next one or the end.
std::optional<Factor> unit_expression(std::string_view text) {
  Factor product{1, {}};
  int sign = 1;
  while (!text.empty()) {
    if (const std::size_t skipped = text.find_first_not_of(" *"); skipped != 0) {
      text.remove_prefix(std::min(skipped, text.size()));
      continue;
    }
    if (text.front() == '/') {
      sign = -1;
      text.remove_prefix(1);
      const std::size_t next = text.find_first_not_of(' ');
      if (next == std::string_view::npos || text[next] == '/') return std::nullopt;  // a slash divides by something
      continue;
    }
    const std::string_view word = text.substr(0, text.find_first_of(" */"));
    const auto factor = unit_power(word);
    if (!factor) return std::nullopt;
    product.scale *= sign > 0 ? factor->scale : 1 / factor->scale;
    product.dimension.length += sign * factor->dimension.length;
    product.dimension.mass += sign * factor->dimension.mass;
    product.dimension.time += sign * factor->dimension.time;
    text.remove_prefix(word.size());
  }
  return product;
}

}  // namespace

double parse_quantity(const std::string& text, const Unit& wanted) {
  const std::string expected =
      *wanted.symbol ? fmt::format("a number in {0}, or one with a unit such as \"1 {0}\"", wanted.symbol) : "a number";
  // from_chars does not depend on the locale.
  const std::size_t begin = text.find_first_not_of(" +");
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + std::min(begin, text.size()), last, value);
  if (error != std::errc() || !std::isfinite(value)) {
    throw InputError(fmt::format("\"{}\" is not a number; expected {}", text, expected));
  }
  const std::string_view rest(end, static_cast<std::size_t>(last - end));
  if (rest.find_first_not_of(' ') == std::string_view::npos) return value;
  const auto unit = unit_expression(rest);
  if (!unit) throw InputError(fmt::format("\"{}\": unknown unit \"{}\"; expected {}", text, rest, expected));
  if (unit->dimension != wanted.dimension) {
    throw InputError(fmt::format("\"{}\" has the wrong dimension; expected {}", text, expected));
  }
  return value * unit->scale;
}

std::optional<Vec3> parse_vector(const std::string& text, const Unit& wanted) {
  Vec3 vector;
  std::size_t first = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t comma = text.find(',', first);
    if ((comma == std::string::npos) != (k == 2)) return std::nullopt;
    vector[k] = parse_quantity(text.substr(first, comma - first), wanted);
    first = comma + 1;
  }
  return vector;
}

}  // namespace packstone
