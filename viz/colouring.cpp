#include "viz/colouring.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::viz {

namespace {

struct Quantity {
  std::vector<double> values;  ///< (N)
  std::string title;
};

std::vector<double> magnitudes(const Field& field, std::size_t count) {
  std::vector<double> values(count);
  const auto components = static_cast<std::size_t>(field.components);
  for (std::size_t row = 0; row < count; ++row) {
    if (components == 1) {
      values[row] = field.values[row];
      continue;
    }
    double square = 0;
    for (std::size_t k = 0; k < components; ++k) square += std::pow(field.values[row * components + k], 2);
    values[row] = std::sqrt(square);
  }
  return values;
}

std::string titled(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

[[noreturn]] void refuse(const Snapshot& snapshot, const std::string& name) {
  const std::vector<std::string> names = colour_names(snapshot);
  const auto near = nearest_name(name, names);
  throw InputError(fmt::format("the snapshot has no '{}' to colour by{}; there are {}", name,
                               near ? fmt::format(", did you mean '{}'?", *near) : "", joined(names)));
}

/// The numbers to colour by; nothing for categories.
std::optional<Quantity> quantity(const Snapshot& snapshot, const std::string& name) {
  if (colours_categories(name)) return std::nullopt;
  if (name == "radius") return Quantity{snapshot.radius, "radius [m]"};
  const auto field = snapshot.fields.find(coloured_field(name));
  if (field == snapshot.fields.end()) refuse(snapshot, name);
  return Quantity{magnitudes(field->second, snapshot.size()), titled(name, field->second.unit)};
}

std::optional<ValueRange> extent(const std::vector<double>& values) {
  std::optional<ValueRange> range;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (!range) range = {value, value};
    range->first = std::min(range->first, value);
    range->second = std::max(range->second, value);
  }
  return range;
}

/// A scale needs some length even where all values agree.
ValueRange widened(ValueRange range) {
  if (range.first < range.second) return range;
  const double margin = range.first == 0 ? 1 : std::abs(range.first) / 2;
  return {range.first - margin, range.second + margin};
}

Colouring colour_categories(const std::vector<std::int32_t>& category, const std::vector<std::string>& names,
                            const std::string& title) {
  Colouring colouring;
  colouring.title = title;
  const std::int32_t last = category.empty() ? -1 : *std::max_element(category.begin(), category.end());
  std::vector<Colour> palette;
  for (std::int32_t index = 0; index <= last; ++index)
    palette.push_back(category_colour(static_cast<std::size_t>(index)));
  colouring.colours.resize(category.size());
  for (std::size_t row = 0; row < category.size(); ++row) {
    const std::int32_t index = category[row];
    colouring.colours[row] = index < 0 ? no_value : palette[static_cast<std::size_t>(index)];
  }
  for (std::size_t i = 0; i < names.size(); ++i) colouring.entries.push_back({category_colour(i), names[i]});
  return colouring;
}

/// Whole numbers of a field as categories.
Colouring colour_numbered(const Snapshot& snapshot, const std::string& name) {
  const Quantity numbers = *quantity(snapshot, name);
  constexpr std::size_t most_named = 12;
  Colouring colouring;
  colouring.title = numbers.title;
  std::set<std::int64_t> there;
  for (const double value : numbers.values) {
    if (std::isfinite(value) && value != std::nearbyint(value)) {
      throw InputError(
          fmt::format("{}{}: categories have whole numbers, not {:g}; a scale of colours would be right, {}",
                      category_prefix, name, value, name));
    }
    const auto number = std::isfinite(value) ? static_cast<std::int64_t>(value) : -1;
    colouring.colours.push_back(number < 0 ? no_value : category_colour(static_cast<std::size_t>(number)));
    if (number >= 0 && there.size() <= most_named) there.insert(number);
  }
  if (there.size() > most_named) return colouring;
  for (const std::int64_t number : there) {
    colouring.entries.push_back({category_colour(static_cast<std::size_t>(number)), std::to_string(number)});
  }
  return colouring;
}

Colouring colour_groups(const Snapshot& snapshot) {
  std::vector<std::string> names;
  for (const GroupRecord& group : snapshot.groups) names.push_back(group.name);
  return colour_categories(snapshot.type, names, "");
}

}  // namespace

ValueRange united(const std::optional<ValueRange>& a, const ValueRange& b) {
  return a ? ValueRange{std::min(a->first, b.first), std::max(a->second, b.second)} : b;
}

bool colours_categories(const std::string& name) {
  return name == "type" || name == "material" || name.starts_with(category_prefix);
}

bool colour_needs_fields(const std::string& name) { return name != "type" && name != "material" && name != "radius"; }

std::string coloured_field(const std::string& name) {
  const std::string plain = name.starts_with(category_prefix) ? name.substr(std::strlen(category_prefix)) : name;
  return plain == "speed" ? "velocity" : plain;
}

std::vector<std::string> colour_names(const Snapshot& snapshot) {
  std::vector<std::string> names = {"type", "material", "radius"};
  if (snapshot.fields.contains("velocity")) names.push_back("speed");
  for (const auto& [name, field] : snapshot.fields) names.push_back(name);
  return names;
}

std::optional<ValueRange> value_range(const Snapshot& snapshot, const std::string& name) {
  const auto numbers = quantity(snapshot, name);
  return numbers ? extent(numbers->values) : std::nullopt;
}

Colouring colour_particles(const Snapshot& snapshot, const std::string& name, std::optional<ValueRange> range) {
  if (range && !(range->first < range->second)) {
    throw InputError(fmt::format("the colour range {} to {} is not ascending", range->first, range->second));
  }
  if (name == "type") return colour_groups(snapshot);
  if (name.starts_with(category_prefix)) {
    return colour_numbered(snapshot, name.substr(std::strlen(category_prefix)));
  }
  if (name == "material") return colour_categories(snapshot.material, snapshot.material_names, "material");
  const Quantity numbers = *quantity(snapshot, name);
  Colouring colouring;
  colouring.title = numbers.title;
  colouring.range = range ? *range : widened(extent(numbers.values).value_or(ValueRange{0, 1}));
  const auto [low, high] = *colouring.range;
  colouring.colours.reserve(numbers.values.size());
  for (const double value : numbers.values)
    colouring.colours.push_back(sequential_colour((value - low) / (high - low)));
  return colouring;
}

}  // namespace packstone::viz
