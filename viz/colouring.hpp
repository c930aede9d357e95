// Which colour a particle has, and what the legend says about it. Shared by the view in space and the slice.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/particle_view.hpp"
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

/// The colour of each row, worked out when it is asked for.
class RowColours {
 public:
  RowColours() = default;
  RowColours(std::size_t rows, std::function<Colour(std::size_t row)> colour_of)
      : rows_(rows), colour_of_(std::move(colour_of)) {}
  /// Colours that outlive this.
  RowColours(std::span<const Colour> colours)
      : RowColours(colours.size(), [colours](std::size_t row) { return colours[row]; }) {}

  std::size_t size() const { return rows_; }
  Colour operator[](std::size_t row) const { return colour_of_(row); }

 private:
  std::size_t rows_ = 0;
  std::function<Colour(std::size_t)> colour_of_;
};

/// Colours of the particles of one snapshot, whose columns they look at.
struct Colouring : ColourKey {
  RowColours colours;
  bool too_many_to_name = false;  ///< categories, which therefore have no entries
};

/// A legend names no more numbers than these.
inline constexpr std::size_t most_named = 12;

/// Before the name of a field whose whole numbers are categories: "category:cluster".
inline constexpr const char* category_prefix = "category:";

/// Whether the name stands for categories, which have no range: "type", "material", offender_field and those with the
/// prefix.
bool colours_categories(const std::string& name);

/// "type", "material", "radius", "speed" (where there are velocities) and the fields of the snapshot.
std::vector<std::string> colour_names(const ParticleView& particles);

/// Lowest and highest value of a quantity in one snapshot; NaN does not count. Vectors count by magnitude. For movies:
/// unite those of all frames. Nothing for "type" and "material", and where there are no particles.
/// Throws InputError that lists the names there are.
std::optional<ValueRange> value_range(const ParticleView& particles, const std::string& name);

/// Colours by the named quantity; without a range the scale spans the snapshot's own values. Categories of a field have
/// the colour of their number, 8 in turn; negative ones, as of particles in no cluster, have none. Their legend names
/// them where they are few.
/// Throws InputError that lists the names there are, when the range is not ascending, or for categories of other than
/// whole numbers.
Colouring colour_particles(const ParticleView& particles, const std::string& name, std::optional<ValueRange> range);

/// Categories of rows; of a number below zero no_value, of one beyond the palette the usual colour.
RowColours category_colours(std::span<const std::int32_t> category, std::vector<Colour> palette);

}  // namespace packstone::viz
