#include "analysis/measures.hpp"

#include <algorithm>

#include "analysis/time/course.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::analysis {

namespace {

void check_selection(const std::vector<std::string>& selection) {
  std::vector<std::string> names;
  for (const auto& measure : all_measures()) names.push_back(measure.name);
  names.push_back(course_name);  // of series; see analyze_series
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
      {"packing", "solid fraction and height of the bed, of its interior and of regions, profiles", measure_packing},
      {"surface", "free surface by a ball rolling over the bed: the volume under it, height, roughness",
       measure_surface},
      {"voronoi", "local solid fraction by radical Voronoi cells", measure_voronoi, true, voronoi_fields},
      {"structure", "coordination, radial distribution, bond order, fabric", measure_structure, false,
       structure_fields},
      {"pores", "sizes of the pores", measure_pores, true},
      {"segregation", "how well the types are mixed: by layers, rings, cells and contacts, against random mixing",
       measure_segregation},
      {"clusters", "clusters of like particles that touch, are near or press hard, against random labels",
       measure_clusters, false, cluster_fields},
      {"forces", "forces of contacts, friction, stress, coarse-grained fields, force chains, k-cores", measure_forces,
       false, force_fields},
      {"communities", "communities of the network of forces", measure_communities, true, community_fields},
      {"time", "how near the packing is to rest, granular temperature by height", measure_time},
  };
  return measures;
}

std::vector<const Measure*> selected_measures(const std::vector<std::string>& selection) {
  check_selection(selection);
  std::vector<const Measure*> measures;
  for (const auto& measure : all_measures()) {
    const bool selected = selection.empty()
                              ? !measure.on_request
                              : std::find(selection.begin(), selection.end(), measure.name) != selection.end();
    if (selected) measures.push_back(&measure);
  }
  return measures;
}

std::vector<MeasureResult> analyze(const Snapshot& snapshot, const std::vector<std::string>& selection,
                                   const Options& options) {
  const auto measures = selected_measures(selection);
  const Context context = make_context(snapshot, options);
  std::vector<MeasureResult> results;
  for (const Measure* measure : measures) results.push_back(measure->function(snapshot, context));
  return results;
}

}  // namespace packstone::analysis
