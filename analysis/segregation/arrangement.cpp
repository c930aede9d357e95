#include "analysis/segregation/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/segregation/centres.hpp"
#include "analysis/segregation/contact_mixing.hpp"

namespace packstone::analysis {

namespace {

/// What lies at every place.
struct Places {
  std::vector<std::int32_t> label;
  std::vector<double> amount, radius;  // empty where they do not change place
};

/// order: row of the particle that comes to the place of each.
Places places_of(const MixedBed& bed, std::span<const std::int32_t> order) {
  Places places;
  places.label.reserve(order.size());
  for (const std::int32_t row : order) places.label.push_back(bed.list.label[static_cast<std::size_t>(row)]);
  if (!bed.amounts.linked) return places;
  places.amount.reserve(order.size());
  places.radius.reserve(order.size());
  for (const std::int32_t row : order) {
    places.amount.push_back(bed.amounts.of[static_cast<std::size_t>(row)]);
    places.radius.push_back(bed.snapshot.radius[static_cast<std::size_t>(row)]);
  }
  return places;
}

void put_composition(std::vector<double>& numbers, std::size_t first, const MixedBed& bed, const Composition& c) {
  const auto by_species = variance_by_species(c);
  const double share = c.mean[bed.scarcest];
  numbers[first + variance] = std::accumulate(by_species.begin(), by_species.end(), 0.0);
  numbers[first + relative_deviation] = share > 0 ? std::sqrt(by_species[bed.scarcest]) / share : 0;
  numbers[first + entropy] = mixing_entropy(c);
}

std::vector<double> numbers_of(const MixedBed& bed, std::span<const std::int32_t> order) {
  const Places places = places_of(bed, order);
  const std::vector<double>& amount = bed.amounts.linked ? places.amount : bed.amounts.of;
  const std::size_t species = bed.list.size();
  std::vector<double> numbers(index_of_scale(bed.scales.size(), variance), 0.0);

  const auto centres = centres_of(bed.snapshot.position, places.label, amount, species);
  numbers[height_difference] = extent_along(centres, bed.context.frame.axis);
  numbers[centre_distance] = farthest_apart(centres, bed.snapshot.domain.periodic);
  numbers[unlike_contacts] = unlike_share(bed.context.contacts.pairs, places.label);

  const auto put = [&](std::size_t first, const Division& division) {
    put_composition(numbers, first, bed, composition_of(division, places.label, amount, species));
  };
  for (const Part part : {layers_part, rings_part, cells_part}) {
    if (!bed.parts[part].missing.empty()) continue;
    const std::size_t first = index_of(part, variance);
    if (part == layers_part && bed.amounts.linked) {
      put_composition(numbers, first, bed,
                      layer_composition(bed.frame.height, places.radius, bed.layers, places.label, amount, species));
    } else {
      put(first, bed.parts[part].division);
    }
  }
  for (std::size_t k = 0; k < bed.scales.size(); ++k) put(index_of_scale(k, variance), bed.scales[k]);
  return numbers;
}

std::vector<std::int32_t> rows_of(const MixedBed& bed) {
  std::vector<std::int32_t> rows(bed.list.label.size());
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

/// The types one on another.
std::vector<std::int32_t> separated_order(const MixedBed& bed) {
  const auto row = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  const auto rows = rows_of(bed);
  auto places = rows, particles = rows;
  const int axis = longest_axis(bed.snapshot);
  std::stable_sort(places.begin(), places.end(), [&](std::int32_t a, std::int32_t b) {
    return bed.snapshot.position[row(a)][axis] < bed.snapshot.position[row(b)][axis];
  });
  std::stable_sort(particles.begin(), particles.end(),
                   [&](std::int32_t a, std::int32_t b) { return bed.list.label[row(a)] < bed.list.label[row(b)]; });
  std::vector<std::int32_t> order(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) order[row(places[k])] = particles[k];
  return order;
}

}  // namespace

MixingNumbers mixing_numbers(const MixedBed& bed) {
  const auto rows = rows_of(bed);
  const auto numbers = [&](std::span<const std::int32_t> order) { return numbers_of(bed, order); };
  return {.found = numbers(rows),
          .separated = numbers(separated_order(bed)),
          .random = over_random_labels(rows, permutation_count(rows.size()), numbers),
          .model = bed.amounts.linked ? "random exchanges of the particles' places (by " + bed.amounts.noun() +
                                            " the types differ, so each takes its size along)"
                                      : "random permutations of the types among the particles"};
}

}  // namespace packstone::analysis
