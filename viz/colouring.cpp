#include "viz/colouring.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::viz {

namespace {

/// Numbers of the rows; a vector counts by its magnitude.
struct Quantity {
  FieldColumn column;
  std::string title;

  std::size_t rows() const { return column.values.size() / static_cast<std::size_t>(column.components); }
  double operator[](std::size_t row) const {
    const auto components = static_cast<std::size_t>(column.components);
    if (components == 1) return column.values[row];
    double square = 0;
    for (std::size_t k = 0; k < components; ++k) square += std::pow(column.values[row * components + k], 2);
    return std::sqrt(square);
  }
};

std::string titled(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

/// The field of a snapshot that such a name stands for.
std::string coloured_field(const std::string& name) {
  const std::string plain = name.starts_with(category_prefix) ? name.substr(std::strlen(category_prefix)) : name;
  return plain == "speed" ? "velocity" : plain;
}

[[noreturn]] void refuse(const ParticleView& particles, const std::string& name) {
  const std::vector<std::string> names = colour_names(particles);
  const auto near = nearest_name(name, names);
  throw InputError(fmt::format("the snapshot has no '{}' to colour by{}; there are {}", name,
                               near ? fmt::format(", did you mean '{}'?", *near) : "", joined(names)));
}

/// The numbers to colour by; nothing for categories.
std::optional<Quantity> quantity(const ParticleView& particles, const std::string& name) {
  if (colours_categories(name)) return std::nullopt;
  if (name == "radius") return Quantity{{1, "m", particles.radius}, "radius [m]"};
  const auto field = particles.fields.find(coloured_field(name));
  if (field == particles.fields.end()) refuse(particles, name);
  return Quantity{field->second, titled(name, field->second.unit)};
}

std::optional<ValueRange> extent(const Quantity& values) {
  std::optional<ValueRange> range;
  for (std::size_t row = 0; row < values.rows(); ++row) {
    const double value = values[row];
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

Colouring colour_categories(std::span<const std::int32_t> category, const std::vector<std::string>& names,
                            const std::string& title) {
  Colouring colouring;
  colouring.title = title;
  colouring.colours = category_colours(category, {});
  for (std::size_t i = 0; i < names.size(); ++i) colouring.entries.push_back({category_colour(i), names[i]});
  return colouring;
}

/// Whole numbers of a field as categories.
Colouring colour_numbered(const ParticleView& particles, const std::string& name) {
  const Quantity numbers = *quantity(particles, name);
  Colouring colouring;
  colouring.title = numbers.title;
  std::set<std::int64_t> there;
  for (std::size_t row = 0; row < numbers.rows(); ++row) {
    const double value = numbers[row];
    if (std::isfinite(value) && value != std::nearbyint(value)) {
      throw InputError(
          fmt::format("{}{}: categories have whole numbers, not {:g}; a scale of colours would be right, {}",
                      category_prefix, name, value, name));
    }
    const bool counts = std::isfinite(value) && value >= 0 && there.size() <= most_named;
    if (counts) there.insert(static_cast<std::int64_t>(value));
  }
  colouring.colours = RowColours(numbers.rows(), [numbers](std::size_t row) {
    const double value = numbers[row];
    return std::isfinite(value) && value >= 0 ? category_colour(static_cast<std::size_t>(value)) : no_value;
  });
  colouring.too_many_to_name = there.size() > most_named;
  if (colouring.too_many_to_name) return colouring;
  for (const std::int64_t number : there) {
    colouring.entries.push_back({category_colour(static_cast<std::size_t>(number)), std::to_string(number)});
  }
  return colouring;
}

/// Ids of the offenders for the legend, where the snapshot's are at hand.
std::string offenders_named(const ParticleView& particles, const Quantity& mark) {
  constexpr std::size_t most = 3;
  const std::vector<std::int64_t>& id = particles.snapshot->id;
  std::set<std::int64_t> ids;
  for (std::size_t row = 0; row < id.size(); ++row) {
    if (mark[row] == 1) ids.insert(id[row]);
  }
  if (ids.empty()) return "offender";
  std::string text = ids.size() == 1 ? "particle" : "particles";
  std::size_t told = 0;
  for (const std::int64_t one : ids) {
    if (told == most) return text + ", ...";
    text += fmt::format("{} {}", told++ ? "," : "", one);
  }
  return text;
}

/// Of the state in which a run was stopped: who is behind it stands out.
Colouring colour_offenders(const ParticleView& particles) {
  const Quantity mark{particles.fields.at(offender_field), ""};
  Colouring colouring;
  colouring.title = "stopped by";
  colouring.entries = {{offending, offenders_named(particles, mark)}, {touching, "in contact"}, {no_value, "others"}};
  colouring.colours = RowColours(mark.rows(), [mark](std::size_t row) {
    return mark[row] == 1 ? offending : mark[row] == 2 ? touching : no_value;
  });
  return colouring;
}

Colouring colour_groups(const ParticleView& particles) {
  std::vector<std::string> names;
  for (const GroupRecord& group : particles.snapshot->groups) names.push_back(group.name);
  return colour_categories(particles.type, names, "");
}

}  // namespace

ValueRange united(const std::optional<ValueRange>& a, const ValueRange& b) {
  return a ? ValueRange{std::min(a->first, b.first), std::max(a->second, b.second)} : b;
}

bool colours_categories(const std::string& name) {
  return name == "type" || name == "material" || name == offender_field || name.starts_with(category_prefix);
}

std::vector<std::string> colour_names(const ParticleView& particles) {
  std::vector<std::string> names = {"type", "material", "radius"};
  if (particles.fields.contains("velocity")) names.push_back("speed");
  for (const auto& [name, field] : particles.fields) names.push_back(name);
  return names;
}

std::optional<ValueRange> value_range(const ParticleView& particles, const std::string& name) {
  const auto numbers = quantity(particles, name);
  return numbers ? extent(*numbers) : std::nullopt;
}

RowColours category_colours(std::span<const std::int32_t> category, std::vector<Colour> palette) {
  return {category.size(), [category, palette = std::move(palette)](std::size_t row) {
            const std::int32_t index = category[row];
            if (index < 0) return no_value;
            const auto place = static_cast<std::size_t>(index);
            return place < palette.size() ? palette[place] : category_colour(place);
          }};
}

Colouring colour_particles(const ParticleView& particles, const std::string& name, std::optional<ValueRange> range) {
  if (range && !(range->first < range->second)) {
    throw InputError(fmt::format("the colour range {} to {} is not ascending", range->first, range->second));
  }
  if (name == "type") return colour_groups(particles);
  if (name.starts_with(category_prefix)) {
    return colour_numbered(particles, name.substr(std::strlen(category_prefix)));
  }
  if (name == "material") {
    return colour_categories(particles.material, particles.snapshot->material_names, "material");
  }
  if (name == offender_field) {
    if (!particles.fields.contains(name)) refuse(particles, name);
    return colour_offenders(particles);
  }
  const Quantity numbers = *quantity(particles, name);
  Colouring colouring;
  colouring.title = numbers.title;
  colouring.range = range ? *range : widened(extent(numbers).value_or(ValueRange{0, 1}));
  const auto [low, high] = *colouring.range;
  colouring.colours = RowColours(numbers.rows(), [numbers, low = low, high = high](std::size_t row) {
    return sequential_colour((numbers[row] - low) / (high - low));
  });
  return colouring;
}

}  // namespace packstone::viz
