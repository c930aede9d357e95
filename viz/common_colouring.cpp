#include "viz/common_colouring.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace packstone::viz {

namespace {

using Packings = std::vector<ParticleView>;

/// Of all packings; where they hold one value only, what a scale makes of it.
std::optional<ValueRange> common_range(const Packings& packings, const std::string& name) {
  std::optional<ValueRange> range;
  const ParticleView* valued = nullptr;
  for (const ParticleView& packing : packings) {
    const auto own = value_range(packing, name);
    if (!own) continue;
    range = united(range, *own);
    valued = &packing;
  }
  if (!range || range->first < range->second) return range;
  return colour_particles(*valued, name, std::nullopt).range;
}

/// Names of all, each once.
std::vector<LegendEntry> common_names(const std::vector<Colouring>& colourings) {
  std::vector<LegendEntry> entries;
  for (const Colouring& colouring : colourings) {
    for (const LegendEntry& own : colouring.entries) {
      const auto same = [&](const LegendEntry& entry) { return entry.name == own.name; };
      if (std::any_of(entries.begin(), entries.end(), same)) continue;
      entries.push_back({category_colour(entries.size()), own.name});
    }
  }
  return entries;
}

void colour_by_common_names(const Packings& packings, const std::string& name, std::vector<Colouring>& colourings) {
  const std::vector<LegendEntry> entries = common_names(colourings);
  for (std::size_t k = 0; k < packings.size(); ++k) {
    std::vector<Colour> palette;  // of the snapshot's own numbers
    for (const LegendEntry& own : colourings[k].entries) {
      const auto same = [&](const LegendEntry& entry) { return entry.name == own.name; };
      palette.push_back(std::find_if(entries.begin(), entries.end(), same)->colour);
    }
    const auto category = name == "type" ? packings[k].type : packings[k].material;
    colourings[k].colours = category_colours(category, std::move(palette));
    colourings[k].entries = entries;
  }
}

/// Numbers have the same colour everywhere; the legend has those of all, unless they are many.
void name_common_numbers(std::vector<Colouring>& colourings) {
  std::vector<LegendEntry> entries;
  for (const Colouring& colouring : colourings) {
    entries.insert(entries.end(), colouring.entries.begin(), colouring.entries.end());
  }
  const auto number = [](const LegendEntry& entry) { return std::stoll(entry.name); };
  std::sort(entries.begin(), entries.end(),
            [&](const LegendEntry& a, const LegendEntry& b) { return number(a) < number(b); });
  const auto same = [](const LegendEntry& a, const LegendEntry& b) { return a.name == b.name; };
  entries.erase(std::unique(entries.begin(), entries.end(), same), entries.end());
  const auto many = [](const Colouring& colouring) { return colouring.too_many_to_name; };
  if (entries.size() > most_named || std::any_of(colourings.begin(), colourings.end(), many)) entries.clear();
  for (Colouring& colouring : colourings) colouring.entries = entries;
}

}  // namespace

std::vector<Colouring> colour_together(const Packings& packings, const std::string& name,
                                       std::optional<ValueRange> range) {
  if (!range && packings.size() > 1 && !colours_categories(name)) range = common_range(packings, name);
  std::vector<Colouring> colourings;
  for (const ParticleView& packing : packings) colourings.push_back(colour_particles(packing, name, range));
  if (packings.size() == 1) return colourings;
  if (name.starts_with(category_prefix)) {
    name_common_numbers(colourings);
  } else if (name == "type" || name == "material") {
    colour_by_common_names(packings, name, colourings);
  }
  return colourings;
}

}  // namespace packstone::viz
