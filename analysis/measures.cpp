#include "analysis/measures.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::analysis {

namespace {

void check_selection(const std::vector<std::string>& selection) {
  std::vector<std::string> names;
  for (const auto& measure : all_measures()) names.push_back(measure.name);
  for (const auto& name : selection) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const auto nearest = nearest_name(name, names);
    throw InputError("unknown measure '" + name + "'" + (nearest ? "; did you mean '" + *nearest + "'?" : "") +
                     " (there are " + joined(names) + ")");
  }
}

}  // namespace

const std::vector<Measure>& all_measures() {
  static const std::vector<Measure> measures = {
      {"packing", "solid fraction and height of the bed, vertical profile", measure_packing},
      {"structure", "coordination numbers, rattlers", measure_structure},
      {"segregation", "how well the types are mixed along the height, against random mixing", measure_segregation},
      {"clusters", "clusters of touching like particles, against random labels", measure_clusters},
      {"forces", "normal forces, sliding contacts, overlaps", measure_forces},
      {"time", "how near the packing is to rest", measure_time},
      {"voronoi", "local solid fraction by radical Voronoi cells", measure_voronoi, true},
  };
  return measures;
}

std::vector<MeasureResult> analyze(const Snapshot& snapshot, const std::vector<std::string>& selection,
                                   const Options& options) {
  check_selection(selection);
  const Context context = make_context(snapshot, options);
  std::vector<MeasureResult> results;
  for (const auto& measure : all_measures()) {
    const bool selected = selection.empty()
                              ? !measure.on_request
                              : std::find(selection.begin(), selection.end(), measure.name) != selection.end();
    if (selected) results.push_back(measure.function(snapshot, context));
  }
  return results;
}

}  // namespace packstone::analysis
