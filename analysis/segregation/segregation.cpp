// Measure "segregation": how the types are spread over the bed, against random mixing.
#include <algorithm>
#include <cmath>

#include "analysis/measures.hpp"
#include "analysis/segregation/centres.hpp"
#include "analysis/segregation/contact_mixing.hpp"
#include "analysis/segregation/indices.hpp"
#include "analysis/segregation/tables.hpp"

namespace packstone::analysis {

namespace {

/// The quantity, or no value for the reason where there is one.
void add_theory(MeasureResult& result, Quantity quantity, const std::string& reason, double value) {
  if (reason.empty()) quantity.value = value;
  result.quantities.push_back(reason.empty() ? quantity : not_applicable(quantity, reason));
}

void add_rsd_separated(MeasureResult& result, const MixedBed& bed) {
  const double p = bed.missing.empty() ? bed.amounts.share(bed.scarcest) : 1;
  add_theory(
      result,
      {.key = "rsd_separated",
       .label = "relative standard deviation, separated",
       .definition = "sqrt((1 - P) / P), P share of the type with the smallest share: the value of rsd, ring_rsd "
                     "and cell_rsd for compartments of one type each"},
      bed.missing, std::sqrt((1 - p) / p));
}

/// Number of particles that spread as those of a type with their amounts, (sum v)^2 / sum v^2.
std::vector<double> effective_counts(const MixedBed& bed) {
  std::vector<double> squares(bed.list.size(), 0.0), counts;
  for (std::size_t i = 0; i < bed.amounts.of.size(); ++i) {
    squares[static_cast<std::size_t>(bed.list.label[i])] += bed.amounts.of[i] * bed.amounts.of[i];
  }
  for (std::size_t s = 0; s < bed.list.size(); ++s) {
    counts.push_back(bed.amounts.by_species[s] * bed.amounts.by_species[s] / squares[s]);
  }
  return counts;
}

std::string reason_against_height(const MixedBed& bed) {
  if (!bed.missing.empty()) return bed.missing;
  if (bed.context.frame.periodic) return "the domain is periodic along up";
  if (!(bed.context.bed.height > 0)) return "all particles lie below the floor";
  return bed.frame.axis == bed.context.frame.axis ? bed.parts[layers_part].missing : "";
}

void add_height_difference(MeasureResult& result, const MixedBed& bed, const MixingNumbers& numbers) {
  Quantity q{.key = "height_difference",
             .label = "height between the types' centres",
             .definition = "height of the highest centre of a type, weighted by " + bed.amounts.noun() +
                           ", less that of the lowest, over bed_height; uncertainty: standard deviation of the "
                           "difference of these two for types permuted at random among the particles"};
  const std::string reason = reason_against_height(bed);
  if (!reason.empty()) {
    add_missing(result, q, reason);
  } else {
    const BedFrame& up = bed.context.frame;
    const auto centres = centres_of(bed.snapshot.position, bed.list.label, bed.amounts.of, bed.list.size());
    const auto [low, high] = std::minmax_element(centres.begin(), centres.end(), [&](const Vec3& a, const Vec3& b) {
      return up.sign * a[up.axis] < up.sign * b[up.axis];
    });
    const auto lowest = static_cast<std::size_t>(low - centres.begin());
    const auto highest = static_cast<std::size_t>(high - centres.begin());
    const auto effective = effective_counts(bed);
    const double spread = coordinate_variance(bed.snapshot.position, bed.amounts.of, up.axis);
    const double height = bed.context.bed.height;
    q.value = numbers.found[height_difference] / height;
    q.uncertainty = std::sqrt(spread * (1 / effective[lowest] + 1 / effective[highest])) / height;
    q.note = "higher: " + bed.list.species[highest].name + ", lower: " + bed.list.species[lowest].name;
    add_with_band(result, q, transformed(numbers.random[height_difference], 1 / height), numbers.model);
  }
  const Quantity separated{.key = "height_difference_separated",
                           .label = "height between the types' centres, separated",
                           .definition =
                               "1 - (P_a + P_b) / 2, P_a and P_b the smallest shares by volume of two types: "
                               "height_difference of a uniform bed of layers of one type each, these two at "
                               "the bottom and on top"};
  const bool solid = reason.empty() && bed.list.volume > 0;
  add_theory(result, separated, reason.empty() && !solid ? "the particles have no volume" : reason,
             solid ? bed.separated_distance() : 0);
}

std::string reason_against_distance(const MixedBed& bed) {
  if (!bed.missing.empty()) return bed.missing;
  const auto& periodic = bed.snapshot.domain.periodic;
  const bool closed = std::all_of(periodic.begin(), periodic.end(), [](bool p) { return p; });
  return closed ? "the domain is periodic along every axis" : "";
}

/// Length of the longest side of a uniform box with the bed's variance of coordinates, over axes not periodic [m].
double uniform_length(const MixedBed& bed) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (bed.snapshot.domain.periodic[static_cast<std::size_t>(axis)]) continue;
    largest = std::max(largest, coordinate_variance(bed.snapshot.position, bed.amounts.of, axis));
  }
  constexpr double uniform_variance = 1.0 / 12;  // of a uniform distribution, of its length squared
  return std::sqrt(largest / uniform_variance);
}

void add_centre_distance(MeasureResult& result, const MixedBed& bed, const MixingNumbers& numbers) {
  Quantity q{.key = "centre_distance",
             .label = "distance between the types' centres",
             .unit = "m",
             .definition = "largest distance between the centres of two types, weighted by " + bed.amounts.noun() +
                           ", over the axes that are not periodic; uncertainty: standard deviation for random mixing"};
  const std::string reason = reason_against_distance(bed);
  if (!reason.empty()) {
    add_missing(result, q, reason);
  } else {
    q.value = numbers.found[centre_distance];
    q.uncertainty = numbers.random[centre_distance].deviation;
    add_with_band(result, q, numbers.random[centre_distance], numbers.model);
  }
  const Quantity separated{.key = "centre_distance_separated",
                           .label = "distance between the types' centres, separated",
                           .unit = "m",
                           .definition =
                               "(1 - (P_a + P_b) / 2) sqrt(12 var), shares as for "
                               "height_difference_separated, var the largest variance of the particles' "
                               "coordinates along an axis that is not periodic: a uniform bed separated along "
                               "its longest side"};
  const bool solid = reason.empty() && bed.list.volume > 0;
  add_theory(result, separated, reason.empty() && !solid ? "the particles have no volume" : reason,
             solid ? bed.separated_distance() * uniform_length(bed) : 0);
}

void add_contact_mixing(MeasureResult& result, const MixedBed& bed, const MixingNumbers& numbers) {
  const bool by_ends = bed.missing.empty() && bed.list.size_linked();
  Quantity q{.key = "contact_mixing",
             .label = "mixing index of the contacts",
             .definition =
                 "share of the contacts between particles of different types over its expectation for random mixing: "
                 "1 random, near 0 separated, above 1 where unlike particles touch more often; expectation "
                 "1 - sum n (n - 1) / (N (N - 1)), n of N particles of a type (join counts, Moran, J. R. Stat. Soc. B "
                 "10 (1948) 243), or, where types differ in size, n of the N contact ends joined at random (1 - r of "
                 "Newman, Phys. Rev. E 67 (2003) 026126); uncertainty: standard deviation for random mixing"};
  const auto& contacts = bed.context.contacts.pairs;
  if (!bed.missing.empty() || contacts.empty()) {
    add_missing(result, q, bed.missing.empty() ? "no contacts between particles" : bed.missing);
    return;
  }
  const RandomReference random = by_ends ? unlike_share_of_ends(contacts, bed.list) : numbers.random[unlike_contacts];
  const double expected = by_ends ? random.mean : unlike_share_of_labels(bed.list);
  if (!(expected > 0)) {
    add_missing(result, q, "only particles of one type touch others");
    return;
  }
  q.value = numbers.found[unlike_contacts] / expected;
  q.uncertainty = random.deviation / expected;
  q.note = bed.context.contacts.source();
  add_with_band(result, q, transformed(random, 1 / expected),
                by_ends ? "networks whose contact ends are joined at random (types differ in size; exact, no band)"
                        : "random permutations of the types among the particles of the same contact network");
}

}  // namespace

MeasureResult measure_segregation(const Snapshot& snapshot, const Context& context) {
  MeasureResult result{.name = "segregation"};
  const MixedBed bed = mixed_bed(snapshot, context);
  const MixingNumbers numbers = bed.missing.empty() ? mixing_numbers(bed) : MixingNumbers{};
  for (const Part part : {layers_part, rings_part, cells_part}) add_part_indices(result, bed, numbers, part);
  add_rsd_separated(result, bed);
  add_height_difference(result, bed, numbers);
  add_centre_distance(result, bed, numbers);
  add_contact_mixing(result, bed, numbers);
  if (!bed.missing.empty()) return result;
  if (bed.parts[layers_part].missing.empty()) result.tables.push_back(layer_table(bed));
  if (bed.parts[rings_part].missing.empty()) result.tables.push_back(ring_table(bed));
  result.tables.push_back(type_table(bed));
  if (!bed.scales.empty()) result.tables.push_back(scale_table(bed, numbers));
  return result;
}

}  // namespace packstone::analysis
