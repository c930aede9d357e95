// The radial distribution function as quantities and tables.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/species.hpp"
#include "analysis/structure/pair_distribution.hpp"
#include "analysis/structure/parts.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr double default_range = 5;       // mean diameters
constexpr double default_bin = 1.0 / 20;  // mean diameters
constexpr double most_bins = 10'000;
constexpr std::size_t most_types = 10;  // with curves of their own; bounds memory

struct Bins {
  double width = 0;  // [m]
  std::size_t count = 0;
};

/// As the options say, but no farther than half of the window's shortest side.
Bins bins_for(const Options& options, double mean_diameter, const Window& window) {
  const double wanted = options.rdf_range > 0 ? options.rdf_range : default_range * mean_diameter;
  const double range = std::min(wanted, window.size().minCoeff() / 2);
  const double width = options.rdf_bin > 0 ? options.rdf_bin : default_bin * mean_diameter;
  if (!(width > 0) || !(range > 0)) return {};
  const double slack = 1e-9;  // of a bin: rounding loses none
  const double count = std::floor(range / width + slack);
  if (count > most_bins) {
    throw InputError(
        fmt::format("a radial distribution function over {:g} m in bins of {:g} m has {:g} bins; at most {:g}", range,
                    width, count, most_bins));
  }
  return {width, static_cast<std::size_t>(count)};
}

void add_rows(Table& table, const PairDistribution& distribution, const PairCurve& curve,
              const std::vector<double>& leading) {
  for (std::size_t k = 0; k < distribution.bins; ++k) {
    std::vector<double> row = leading;
    const double lower = static_cast<double>(k) * distribution.bin;
    const double error = curve.error[k] > 0 ? curve.error[k] : no_value;
    row.insert(row.end(), {lower, lower + distribution.bin, curve.g[k], error});
    table.rows.push_back(std::move(row));
  }
}

std::string caption(const char* which, const PairDistribution& distribution) {
  return fmt::format(
      "Radial distribution function {}: pairs of centres at distance r over what independent uniform positions would "
      "give in the window, with the density of those places from which r can be seen (Stoyan, Stoyan, Scand. J. Stat. "
      "27 "
      "(2000) 641); {} particles in the window, pairs counted around {} of them; error: standard error as if pairs "
      "were "
      "independent, none where no pair was found",
      which, distribution.particles, distribution.references);
}

}  // namespace

void add_pair_distribution(MeasureResult& result, const Snapshot& snapshot, const Context& context) {
  const double mean_diameter = 2 * context.mean_radius;
  const std::string region =
      std::string(window_definition) + ", sides that are not periodic moved inwards by one mean diameter";
  Quantity peak{.key = "rdf_peak",
                .label = "highest value of g(r)",
                .definition = "highest value of the radial distribution function of all particles in " + region +
                              ", in bins (see table rdf); uncertainty: standard error as if pairs were independent"};
  Quantity place{.key = "rdf_peak_distance",
                 .label = "distance of the highest g(r)",
                 .unit = "m",
                 .definition = "middle of the bin of rdf_peak; uncertainty: the bin's width over sqrt(12)"};
  const SpeciesList list = species_of(snapshot);
  Table total{.key = "rdf", .columns = {{"lower", "m"}, {"upper", "m"}, {"g"}, {"error"}}};
  Table by_types{.key = "rdf_by_types",
                 .columns = {{"type_a", "", ColumnFormat::integer},
                             {"type_b", "", ColumnFormat::integer},
                             {"lower", "m"},
                             {"upper", "m"},
                             {"g"},
                             {"error"}}};

  PairDistribution distribution;
  const WindowOrReason found = bulk_window(snapshot, context, mean_diameter);
  std::string reason = found.reason;
  if (found.window) {
    const Bins bins = bins_for(context.options, mean_diameter, *found.window);
    if (bins.count == 0) {
      reason = mean_diameter > 0 ? "the window of the bulk is too small" : "all radii are 0";
    } else {
      const std::size_t labels = list.size() <= most_types ? list.size() : 0;
      distribution = pair_distribution(snapshot, *found.window, list.label, labels, bins.width, bins.count);
      if (distribution.particles < 2) reason = "fewer than two particles in the window of the bulk";
    }
  }
  total.caption = caption("of all particles", distribution);
  by_types.caption = caption("by pairs of types", distribution) + "; types: " + list.legend();
  if (list.size() > most_types) by_types.caption += fmt::format("; left out with more than {} types", most_types);
  if (!reason.empty()) {
    result.quantities.push_back(not_applicable(peak, reason));
    result.quantities.push_back(not_applicable(place, reason));
  } else {
    const auto& g = distribution.total.g;
    const auto at = static_cast<std::size_t>(std::max_element(g.begin(), g.end()) - g.begin());
    peak.value = g[at];
    peak.uncertainty = distribution.total.error[at];
    place.value = (static_cast<double>(at) + 0.5) * distribution.bin;
    place.uncertainty = distribution.bin / std::sqrt(12.0);
    if (!(g[at] > 0)) {
      place = not_applicable(place, "no pair within the range");
      peak.uncertainty.reset();
    }
    result.quantities.push_back(peak);
    result.quantities.push_back(place);
    add_rows(total, distribution, distribution.total, {});
    std::size_t curve = 0;
    for (std::size_t a = 0; a < list.size() && !distribution.partial.empty(); ++a) {
      for (std::size_t b = a; b < list.size(); ++b) {
        add_rows(by_types, distribution, distribution.partial[curve++],
                 {static_cast<double>(list.species[a].type), static_cast<double>(list.species[b].type)});
      }
    }
  }
  result.tables.push_back(std::move(total));
  result.tables.push_back(std::move(by_types));
}

}  // namespace packstone::analysis
