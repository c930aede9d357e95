#include "viz/common_colouring.hpp"

#include <algorithm>
#include <cstddef>

namespace packstone::viz {

namespace {

using Snapshots = std::vector<std::reference_wrapper<const Snapshot>>;

/// A legend names no more numbers than these, as that of one snapshot.
constexpr std::size_t most_named = 12;

/// Of all snapshots; where they hold one value only, what a scale makes of it.
std::optional<ValueRange> common_range(const Snapshots& snapshots, const std::string& name) {
  std::optional<ValueRange> range;
  const Snapshot* valued = nullptr;
  for (const Snapshot& snapshot : snapshots) {
    const auto own = value_range(snapshot, name);
    if (!own) continue;
    range = united(range, *own);
    valued = &snapshot;
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

void colour_by_common_names(const Snapshots& snapshots, const std::string& name, std::vector<Colouring>& colourings) {
  const std::vector<LegendEntry> entries = common_names(colourings);
  for (std::size_t k = 0; k < snapshots.size(); ++k) {
    std::vector<Colour> palette;  // of the snapshot's own numbers
    for (const LegendEntry& own : colourings[k].entries) {
      const auto same = [&](const LegendEntry& entry) { return entry.name == own.name; };
      palette.push_back(std::find_if(entries.begin(), entries.end(), same)->colour);
    }
    const Snapshot& snapshot = snapshots[k];
    const std::vector<std::int32_t>& category = name == "type" ? snapshot.type : snapshot.material;
    for (std::size_t row = 0; row < category.size(); ++row) {
      const std::int32_t index = category[row];
      if (index < 0 || static_cast<std::size_t>(index) >= palette.size()) continue;
      colourings[k].colours[row] = palette[static_cast<std::size_t>(index)];
    }
    colourings[k].entries = entries;
  }
}

bool named(const Colouring& colouring) {
  return !colouring.entries.empty() || std::all_of(colouring.colours.begin(), colouring.colours.end(),
                                                   [](const Colour& colour) { return colour == no_value; });
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
  if (entries.size() > most_named || !std::all_of(colourings.begin(), colourings.end(), named)) {
    entries.clear();
  }
  for (Colouring& colouring : colourings) colouring.entries = entries;
}

}  // namespace

std::vector<Colouring> colour_together(const Snapshots& snapshots, const std::string& name,
                                       std::optional<ValueRange> range) {
  if (!range && snapshots.size() > 1 && !colours_categories(name)) range = common_range(snapshots, name);
  std::vector<Colouring> colourings;
  for (const Snapshot& snapshot : snapshots) colourings.push_back(colour_particles(snapshot, name, range));
  if (snapshots.size() == 1) return colourings;
  if (name.starts_with(category_prefix)) {
    name_common_numbers(colourings);
  } else if (colours_categories(name)) {
    colour_by_common_names(snapshots, name, colourings);
  }
  return colourings;
}

}  // namespace packstone::viz
