// All measures, in one list, and how to run them.
#pragma once

#include <string>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/particle_fields.hpp"
#include "analysis/result.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

MeasureResult measure_packing(const Snapshot& snapshot, const Context& context);
MeasureResult measure_surface(const Snapshot& snapshot, const Context& context);
MeasureResult measure_structure(const Snapshot& snapshot, const Context& context);
MeasureResult measure_pores(const Snapshot& snapshot, const Context& context);
MeasureResult measure_segregation(const Snapshot& snapshot, const Context& context);
MeasureResult measure_clusters(const Snapshot& snapshot, const Context& context);
MeasureResult measure_forces(const Snapshot& snapshot, const Context& context);
MeasureResult measure_communities(const Snapshot& snapshot, const Context& context);
MeasureResult measure_time(const Snapshot& snapshot, const Context& context);
MeasureResult measure_voronoi(const Snapshot& snapshot, const Context& context);

/// What the measures know of every particle.
std::vector<ParticleField> structure_fields(const Snapshot& snapshot, const Context& context);
std::vector<ParticleField> cluster_fields(const Snapshot& snapshot, const Context& context);
std::vector<ParticleField> force_fields(const Snapshot& snapshot, const Context& context);
std::vector<ParticleField> community_fields(const Snapshot& snapshot, const Context& context);
std::vector<ParticleField> voronoi_fields(const Snapshot& snapshot, const Context& context);

struct Measure {
  std::string name;
  std::string description;  ///< one line
  MeasureResult (*function)(const Snapshot&, const Context&);
  bool on_request = false;  ///< takes long: only where it is named
  std::vector<ParticleField> (*fields)(const Snapshot&, const Context&) = nullptr;  ///< the same ones for any snapshot
};

/// In the order of the output.
const std::vector<Measure>& all_measures();

/// The measures named, in the order of all_measures(); all but those on request when the selection is empty.
/// Throws InputError for an unknown name, naming the nearest and all there are.
std::vector<const Measure*> selected_measures(const std::vector<std::string>& selection);

/// The selected measures (selected_measures) of one snapshot.
/// Throws InputError for an unknown name and for a snapshot that cannot be measured (make_context).
std::vector<MeasureResult> analyze(const Snapshot& snapshot, const std::vector<std::string>& selection = {},
                                   const Options& options = {});

}  // namespace packstone::analysis
