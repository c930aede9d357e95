#include "analysis/species.hpp"

#include <cmath>
#include <numeric>

#include "core/geometry.hpp"
#include "core/text.hpp"

namespace packstone::analysis {

namespace {

constexpr double link_threshold = 0.1;  // of the mean

}  // namespace

bool SpeciesList::size_linked() const {
  std::vector<double> volumes;
  for (const auto& s : species) volumes.push_back(s.volume);
  return linked(volumes);
}

bool SpeciesList::linked(const std::vector<double>& by_species) const {
  const double total = std::accumulate(by_species.begin(), by_species.end(), 0.0);
  const double mean = total / static_cast<double>(label.size());
  for (std::size_t s = 0; s < species.size(); ++s) {
    if (std::abs(by_species[s] / static_cast<double>(species[s].count) - mean) > link_threshold * mean) return true;
  }
  return false;
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
