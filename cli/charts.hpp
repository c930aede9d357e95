// The charts that plot and report draw, by name.
#pragma once

#include <string>
#include <vector>

#include "core/run_folder.hpp"
#include "viz/chart.hpp"

namespace packstone::cli {

/// "energy", "kinetic", "packing", "height", "coordination", "account", "profile", "composition",
/// "mixture" (one point a run of two kinds of particles).
const std::vector<std::string>& chart_names();

/// One chart of one or several runs. Throws InputError for an unknown name, naming the nearest, or for a single
/// snapshot where the chart is over time.
viz::Chart make_chart(const std::string& name, const std::vector<RunReader>& runs);

/// Name of a run in legends and tables: its folder's.
std::string run_label(const RunReader& run);

}  // namespace packstone::cli
