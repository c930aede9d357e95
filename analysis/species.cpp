#include "analysis/species.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry.hpp"
#include "core/text.hpp"

namespace packstone::analysis {

namespace {

constexpr double size_link_threshold = 0.1;

}  // namespace

bool SpeciesList::size_linked() const {
  const double mean = volume / static_cast<double>(label.size());
  return std::any_of(species.begin(), species.end(), [&](const Species& s) {
    return std::abs(s.volume / static_cast<double>(s.count) - mean) > size_link_threshold * mean;
  });
}

std::string SpeciesList::legend() const {
  std::vector<std::string> names;
  for (const auto& s : species) names.push_back(std::to_string(s.type) + " " + s.name);
  return joined(names);
}

SpeciesList species_of(const Snapshot& snapshot) {
  std::vector<Species> groups(snapshot.groups.size());
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    Species& group = groups[static_cast<std::size_t>(snapshot.type[i])];
    ++group.count;
    group.volume += sphere_volume(snapshot.radius[i]);
  }
  SpeciesList list;
  std::vector<std::int32_t> label_of(groups.size(), 0);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].count == 0) continue;
    label_of[g] = static_cast<std::int32_t>(list.species.size());
    list.volume += groups[g].volume;
    list.species.push_back({static_cast<std::int32_t>(g), snapshot.groups[g].name, groups[g].count, groups[g].volume,
                            snapshot.groups[g].density});
  }
  list.label.reserve(snapshot.size());
  for (std::int32_t type : snapshot.type) list.label.push_back(label_of[static_cast<std::size_t>(type)]);
  return list;
}

}  // namespace packstone::analysis
