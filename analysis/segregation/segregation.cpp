// Measure "segregation": how the types are spread over the height, against random mixing.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/measures.hpp"
#include "analysis/segregation/composition.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

constexpr double least_contrast = 1e-9;  // of s0^2: below, random and separated cannot be told apart

const char* const layer_text =
    "horizontal layers one mean diameter thick (at most 2000) from the floor to the highest sphere";

struct Mixing {
  SpeciesList list;
  Layers layers;
  Composition composition;
  std::vector<double> variance;  // (species)
  RandomMixing random;

  double observed() const { return std::accumulate(variance.begin(), variance.end(), 0.0); }
  double separated(std::size_t s) const { return composition.mean[s] * (1 - composition.mean[s]); }
  double separated() const {
    double sum = 0;
    for (std::size_t s = 0; s < composition.species; ++s) sum += separated(s);
    return sum;
  }
  std::string model() const {
    return random.size_linked ? "random samples of the mixture (types differ in size, so labels cannot change places), "
                                "layers taken as independent and normal"
                              : "random permutations of the types among the particles";
  }
};

/// Empty when the types can be told apart; else why not.
std::string reason_against(const SpeciesList& list, const Layers& layers) {
  if (list.label.empty()) return "no particles";
  if (list.size() < 2) return "the packing has one type of particle only";
  if (std::any_of(list.species.begin(), list.species.end(), [](const Species& s) { return !(s.volume > 0); })) {
    return "a type has no solid volume";
  }
  if (layers.count < 2) return "the packing is one layer thick";
  return "";
}

Mixing mixing_of(const Snapshot& snapshot, const Context& context, SpeciesList list, const Layers& layers) {
  Mixing m{std::move(list), layers, {}, {}, {}};
  const LayerPieces pieces = cut_into_layers(context.frame.height, snapshot.radius, layers, Outside::to_nearest_layer);
  m.composition = composition_of(pieces, layers, m.list.label, m.list.size());
  m.variance = variance_over_layers(m.composition);
  m.random = random_mixing(pieces, layers, m.list, m.composition, snapshot.radius);
  return m;
}

void add_lacey(MeasureResult& result, Quantity lacey, const Mixing& m) {
  const double separated = m.separated(), contrast = separated - m.random.expected;
  if (!(contrast > least_contrast * separated)) {
    const char* const reason = "too few particles a layer: random mixing looks separated";
    add_without_reference(result, not_applicable(lacey, reason), reason);
    return;
  }
  lacey.value = (separated - m.observed()) / contrast;
  lacey.uncertainty = m.random.total.deviation / contrast;
  add_with_reference(result, lacey, {(separated - m.random.total.mean) / contrast, *lacey.uncertainty}, m.model());
}

void add_intensity(MeasureResult& result, Quantity intensity, const Mixing& m) {
  const double separated = m.separated();
  intensity.value = m.observed() / separated;
  intensity.uncertainty = m.random.total.deviation / separated;
  add_with_reference(result, intensity, {m.random.total.mean / separated, *intensity.uncertainty}, m.model());
}

/// Where a species lies, by volume.
struct Centre {
  double height = 0;     // of the centre of its solid volume [m]
  double effective = 0;  // number of particles, (sum v)^2 / sum v^2
};

std::vector<Centre> centres_of(const Snapshot& snapshot, const std::vector<double>& height, const SpeciesList& list) {
  std::vector<Centre> centres(list.size());
  std::vector<double> squares(list.size(), 0.0);
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const auto s = static_cast<std::size_t>(list.label[i]);
    const double v = sphere_volume(snapshot.radius[i]);
    centres[s].height += v / list.species[s].volume * height[i];
    squares[s] += v * v;
  }
  for (std::size_t s = 0; s < list.size(); ++s) {
    centres[s].effective = list.species[s].volume * list.species[s].volume / squares[s];
  }
  return centres;
}

/// Variance of the particles' heights, weighted by volume, for a population of N [m2].
double height_variance(const Snapshot& snapshot, const std::vector<double>& height, double volume) {
  double mean = 0, variance = 0;
  const double n = static_cast<double>(snapshot.size());
  for (std::size_t i = 0; i < snapshot.size(); ++i) mean += sphere_volume(snapshot.radius[i]) / volume * height[i];
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    variance += sphere_volume(snapshot.radius[i]) / volume * (height[i] - mean) * (height[i] - mean);
  }
  return variance * n / (n - 1);
}

void add_height_difference(MeasureResult& result, Quantity q, const Snapshot& snapshot, const Context& context,
                           const SpeciesList& list) {
  if (!(context.bed.height > 0)) {
    result.quantities.push_back(not_applicable(
        q, context.frame.periodic ? "the domain is periodic along up" : "all particles lie below the floor"));
    return;
  }
  const auto centres = centres_of(snapshot, context.frame.height, list);
  const auto [low, high] = std::minmax_element(centres.begin(), centres.end(),
                                               [](const Centre& a, const Centre& b) { return a.height < b.height; });
  const double spread = height_variance(snapshot, context.frame.height, list.volume);
  q.value = (high->height - low->height) / context.bed.height;
  q.uncertainty = std::sqrt(spread * (1 / low->effective + 1 / high->effective)) / context.bed.height;
  q.note = "higher: " + list.species[static_cast<std::size_t>(high - centres.begin())].name +
           ", lower: " + list.species[static_cast<std::size_t>(low - centres.begin())].name;
  result.quantities.push_back(q);
}

Table composition_table(const Mixing& m) {
  Table table{.key = "composition",
              .caption = "Share of each type (" + m.list.legend() + ") of the solid in " + std::string(layer_text) +
                         "; expected: its share of all solid; spread: standard deviation in " + m.model() +
                         "; z: (share - expected) / spread",
              .columns = {{"lower", "m"},
                          {"upper", "m"},
                          {"type", "", ColumnFormat::integer},
                          {"share"},
                          {"expected"},
                          {"spread"},
                          {"z"}}};
  const double none = std::nan("");
  for (std::size_t l = 0; l < m.layers.count; ++l) {
    for (std::size_t s = 0; s < m.list.size(); ++s) {
      const bool empty = !(m.composition.layer[l] > 0);
      const double spread = std::sqrt(std::max(0.0, m.random.variance[l * m.list.size() + s]));
      const double share = empty ? none : m.composition.share(l, s), expected = m.composition.mean[s];
      table.rows.push_back({m.layers.lower(l), m.layers.upper(l), static_cast<double>(m.list.species[s].type), share,
                            expected, empty ? none : spread, spread > 0 ? (share - expected) / spread : none});
    }
  }
  return table;
}

Table species_table(const Snapshot& snapshot, const Context& context, const Mixing& m) {
  Table table{.key = "types",
              .caption = "Types (" + m.list.legend() +
                         "): share of the solid, height of its centre, intensity of "
                         "segregation s^2 / s0^2 of the type alone",
              .columns = {{"type", "", ColumnFormat::integer},
                          {"particles", "", ColumnFormat::integer},
                          {"share"},
                          {"centre_height", "m"},
                          {"intensity"}}};
  const auto centres = centres_of(snapshot, context.frame.height, m.list);
  for (std::size_t s = 0; s < m.list.size(); ++s) {
    table.rows.push_back({static_cast<double>(m.list.species[s].type), static_cast<double>(m.list.species[s].count),
                          m.list.share(s), centres[s].height, m.variance[s] / m.separated(s)});
  }
  return table;
}

}  // namespace

MeasureResult measure_segregation(const Snapshot& snapshot, const Context& context) {
  const Quantity lacey{
      .key = "lacey",
      .label = "Lacey's mixing index",
      .definition =
          "M = (s0^2 - s^2) / (s0^2 - sr^2): 1 random, 0 separated (Lacey, J. Appl. Chem. 4 (1954) 257); s^2 "
          "variance of the types' volume shares over " +
          std::string(layer_text) +
          ", weighted by solid volume and summed over the types; s0^2 = sum P (1 - P); sr^2 expectation of s^2 "
          "for random mixing, corrected for finite number and cut particles; uncertainty: standard deviation "
          "for random mixing"};
  const Quantity intensity{.key = "intensity",
                           .label = "intensity of segregation",
                           .definition =
                               "I = s^2 / s0^2, 1 separated (Danckwerts, Appl. Sci. Res. A 3 (1952) 279); s^2, "
                               "s0^2 and uncertainty as for lacey"};
  const Quantity difference{.key = "height_difference",
                            .label = "height between the types' centres",
                            .definition =
                                "height of the highest centre of solid volume of a type less that of the "
                                "lowest, over bed_height; uncertainty: standard deviation for types permuted "
                                "at random among the particles"};
  MeasureResult result{.name = "segregation"};
  SpeciesList list = species_of(snapshot);
  const double wanted =
      context.options.segregation_layer > 0 ? context.options.segregation_layer : 2 * context.mean_radius;
  const Layers layers = layers_over_bed(context.frame, snapshot.radius, wanted);
  if (const std::string reason = reason_against(list, layers); !reason.empty()) {
    for (const Quantity& q : {lacey, intensity}) add_without_reference(result, not_applicable(q, reason), reason);
    result.quantities.push_back(not_applicable(difference, reason));
    return result;
  }
  const Mixing mixing = mixing_of(snapshot, context, std::move(list), layers);
  add_lacey(result, lacey, mixing);
  add_intensity(result, intensity, mixing);
  add_height_difference(result, difference, snapshot, context, mixing.list);
  result.tables.push_back(composition_table(mixing));
  result.tables.push_back(species_table(snapshot, context, mixing));
  return result;
}

}  // namespace packstone::analysis
