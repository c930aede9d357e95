// Which colour a particle has, and what the legend says about it. Shared by the view in space and the slice.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/snapshot.hpp"
#include "viz/style.hpp"

namespace packstone::viz {

/// Lowest and highest value of a colour scale, SI.
using ValueRange = std::pair<double, double>;

/// Spans both; the second where there is no first.
ValueRange united(const std::optional<ValueRange>& a, const ValueRange& b);

struct LegendEntry {
  Colour colour;
  std::string name;
};

/// What colours mean.
struct ColourKey {
  std::string title;                   ///< of the legend, with the unit: "speed [m/s]"
  std::vector<LegendEntry> entries;    ///< categories; empty for a scale
  std::optional<ValueRange> range;     ///< of the colour scale; absent for categories
  ColourMap map = ColourMap::viridis;  ///< of the colour scale

  bool empty() const { return !range && entries.empty(); }
};

/// Colours of the particles of one snapshot.
struct Colouring : ColourKey {
  std::vector<Colour> colours;  ///< (N), row by row
};

/// Before the name of a field whose whole numbers are categories: "category:cluster".
inline constexpr const char* category_prefix = "category:";

/// Whether the name stands for categories, which have no range: "type", "material" and those with the prefix.
bool colours_categories(const std::string& name);

/// Whether a snapshot without its fields lacks what to colour by.
bool colour_needs_fields(const std::string& name);

/// The field of a snapshot that such a name stands for.
std::string coloured_field(const std::string& name);

/// "type", "material", "radius", "speed" (where there are velocities) and the fields of the snapshot.
std::vector<std::string> colour_names(const Snapshot& snapshot);

/// Lowest and highest value of a quantity in one snapshot; NaN does not count. Vectors count by magnitude. For movies:
/// unite those of all frames. Nothing for "type" and "material", and where there are no particles.
/// Throws InputError that lists the names there are.
std::optional<ValueRange> value_range(const Snapshot& snapshot, const std::string& name);

/// Colours by the named quantity; without a range the scale spans the snapshot's own values. Categories of a field have
/// the colour of their number, 8 in turn; negative ones, as of particles in no cluster, have none. Their legend names
/// them where they are few.
/// Throws InputError that lists the names there are, when the range is not ascending, or for categories of other than
/// whole numbers.
Colouring colour_particles(const Snapshot& snapshot, const std::string& name, std::optional<ValueRange> range);

}  // namespace packstone::viz
