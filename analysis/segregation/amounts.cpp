#include "analysis/segregation/amounts.hpp"

#include <numeric>

#include "core/geometry.hpp"

namespace packstone::analysis {

std::string Amounts::noun() const {
  if (by == ShareBy::number) return "number";
  return by == ShareBy::mass ? "mass" : "volume";
}

Amounts amounts_of(const Snapshot& snapshot, const SpeciesList& list, ShareBy by) {
  Amounts amounts{.by = by, .of = {}, .by_species = std::vector<double>(list.size(), 0.0)};
  amounts.of.reserve(snapshot.size());
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    double amount = 1;
    if (by == ShareBy::volume) amount = sphere_volume(snapshot.radius[i]);
    if (by == ShareBy::mass) amount = snapshot.mass(i);
    amounts.of.push_back(amount);
    amounts.by_species[static_cast<std::size_t>(list.label[i])] += amount;
  }
  amounts.total = std::accumulate(amounts.by_species.begin(), amounts.by_species.end(), 0.0);
  amounts.linked = !list.label.empty() && list.linked(amounts.by_species);
  return amounts;
}

}  // namespace packstone::analysis
