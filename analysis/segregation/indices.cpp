#include "analysis/segregation/indices.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace packstone::analysis {

namespace {

constexpr double least_contrast = 1e-9;  // of s0^2: below, random and separated cannot be told apart

struct PartWords {
  const char* prefix;  // of keys
  const char* suffix;  // of labels
  const char* one;
  const char* many;
};

constexpr std::array<PartWords, part_count> part_words = {
    {{"", "", "layer", "layers"}, {"ring_", ", rings", "ring", "rings"}, {"cell_", ", cells", "cell", "cells"}}};

enum Index : std::size_t { lacey, intensity, rsd, mixing, index_count };

std::array<Quantity, index_count> indices_of(const MixedBed& bed, Part part) {
  const PartWords& words = part_words[part];
  const std::string prefix = words.prefix, suffix = words.suffix, by = bed.amounts.noun();
  const std::string as_lacey = part == layers_part ? "lacey" : prefix + "lacey";
  std::array<Quantity, index_count> q;
  q[lacey] = {.key = prefix + "lacey",
              .label = "Lacey's mixing index" + suffix,
              .definition =
                  "M = (s0^2 - s^2) / (s0^2 - sr^2): 1 random, 0 separated (Lacey, J. Appl. Chem. 4 (1954) "
                  "257); s^2 variance of the types' shares by " +
                  by + " over " + compartments_text(bed, part) + ", weighted by " + by +
                  " and summed over the types; s0^2 = sum P (1 - P); sr^2 expectation of s^2 for random "
                  "mixing of so many particles; uncertainty: standard deviation for random mixing"};
  q[intensity] = {.key = prefix + "intensity",
                  .label = "intensity of segregation" + suffix,
                  .definition =
                      "I = s^2 / s0^2, 1 separated (Danckwerts, Appl. Sci. Res. A 3 (1952) 279); s^2, s0^2 "
                      "and uncertainty as for " +
                      as_lacey};
  q[rsd] = {.key = prefix + "rsd",
            .label = "relative standard deviation" + suffix,
            .definition = "s / P of the type with the smallest share P by " + by + ", s^2 its part of the s^2 of " +
                          as_lacey +
                          ": coefficient of variation, 0 evenly mixed, sqrt((1 - P) / P) separated (rsd_separated); "
                          "uncertainty: standard deviation for random mixing"};
  if (bed.missing.empty()) q[rsd].note = "of " + bed.list.species[bed.scarcest].name;
  q[mixing] = {.key = prefix + "entropy",
               .label = "mixing entropy" + suffix,
               .definition = "H / H0, H = - sum W/W_all sum c ln c over " + std::string(words.many) +
                             " and types, c share of a type in a " + words.one + " that holds the part W/W_all by " +
                             by +
                             ", H0 = - sum P ln P: 1 evenly mixed, 0 separated (Shannon, Bell Syst. Tech. J. 27 "
                             "(1948) 379; Gu, Chen, Chem. Eng. Res. Des. (2014)); uncertainty: standard "
                             "deviation for random mixing"};
  return q;
}

Quantity band_end(const Quantity& quantity, bool upper) {
  return {.key = quantity.key + (upper ? "_random_high" : "_random_low"),
          .label = quantity.label + (upper ? ", random, high" : ", random, low"),
          .unit = quantity.unit,
          .definition = std::string(upper ? "97.5th" : "2.5th") + " percentile of " + quantity.key +
                        " over the arrangements of " + quantity.key + "_random"};
}

void add_band(MeasureResult& result, const Quantity& quantity, const RandomReference& reference,
              const std::string& reason) {
  for (const bool upper : {false, true}) {
    Quantity end = band_end(quantity, upper);
    end.value = upper ? reference.high : reference.low;
    result.quantities.push_back(end.value ? end : not_applicable(end, reason));
  }
}

void add_index(MeasureResult& result, Quantity quantity, double value, const RandomReference& reference,
               const std::string& model) {
  quantity.value = value;
  quantity.uncertainty = reference.deviation;
  add_with_band(result, quantity, reference, model);
}

}  // namespace

bool LaceyScale::exists() const { return contrast() > least_contrast * separated; }

LaceyScale lacey_scale(const MixedBed& bed, const Division& division, const RandomReference& random) {
  LaceyScale scale{bed.separated_variance(), random.mean};
  if (bed.amounts.linked) return scale;
  const auto composition = composition_of(division, bed.list.label, bed.amounts.of, bed.list.size());
  scale.random = expected_variance(random_variance(division, bed.list, bed.amounts, composition), composition);
  return scale;
}

RandomReference transformed(const RandomReference& reference, double factor, double offset) {
  const auto at = [&](const std::optional<double>& x) { return x ? std::optional(factor * *x + offset) : x; };
  RandomReference r{factor * reference.mean + offset, std::abs(factor) * reference.deviation, at(reference.low),
                    at(reference.high)};
  if (factor < 0) std::swap(r.low, r.high);
  return r;
}

void add_with_band(MeasureResult& result, const Quantity& quantity, const RandomReference& reference,
                   const std::string& model) {
  add_with_reference(result, quantity, reference, model);
  add_band(result, quantity, reference, "too few random arrangements of so many particles");
}

void add_missing(MeasureResult& result, const Quantity& quantity, const std::string& reason) {
  add_without_reference(result, not_applicable(quantity, reason), reason);
  add_band(result, quantity, {}, reason);
}

void add_part_indices(MeasureResult& result, const MixedBed& bed, const MixingNumbers& numbers, Part part) {
  const auto q = indices_of(bed, part);
  const std::string reason = bed.missing.empty() ? bed.parts[part].missing : bed.missing;
  if (!reason.empty()) {
    for (const Quantity& index : q) add_missing(result, index, reason);
    return;
  }
  const auto found = [&](DivisionNumber number) { return numbers.found[index_of(part, number)]; };
  const auto random = [&](DivisionNumber number) { return numbers.random[index_of(part, number)]; };
  const LaceyScale scale = lacey_scale(bed, bed.parts[part].division, random(variance));
  if (scale.exists()) {
    const double factor = -1 / scale.contrast();
    add_index(result, q[lacey], scale(found(variance)),
              transformed(random(variance), factor, scale.separated / scale.contrast()), numbers.model);
  } else {
    add_missing(result, q[lacey],
                "too few particles a " + std::string(part_words[part].one) + ": random mixing looks separated");
  }
  add_index(result, q[intensity], found(variance) / scale.separated, transformed(random(variance), 1 / scale.separated),
            numbers.model);
  add_index(result, q[rsd], found(relative_deviation), random(relative_deviation), numbers.model);
  add_index(result, q[mixing], found(entropy), random(entropy), numbers.model);
}

std::string compartments_text(const MixedBed& bed, Part part) {
  const Options& options = bed.context.options;
  if (part == rings_part) {
    return "rings of equal area about the container's axis (else the middle of the domain) along " +
           std::string(axis_names[bed.frame.axis]) + " out to the farthest centre (" +
           (options.segregation_rings > 0 ? "as many as chosen" : "the outermost about one diameter wide") +
           "), particles by their centres";
  }
  if (part == cells_part) {
    return "the cells into which the box around the bed divides evenly, as near to cubes of " +
           std::string(options.segregation_cell > 0 ? "the chosen edge" : "three diameters sum d^4 / sum d^3") +
           " as can be, particles by their centres";
  }
  const std::string thickness = options.segregation_layer > 0 ? "of the chosen thickness" : "one mean diameter thick";
  if (bed.frame.axis == bed.context.frame.axis) {
    return "horizontal layers " + thickness + " (at most 2000) from the floor to the highest sphere";
  }
  return "layers across " + std::string(axis_names[bed.frame.axis]) + " " + thickness +
         " (at most 2000) from the lowest to the highest point of any sphere";
}

}  // namespace packstone::analysis
