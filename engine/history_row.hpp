// One row of history.csv.
#pragma once

#include <string>
#include <vector>

#include "core/bed.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/monitor.hpp"

namespace packstone::engine {

/// Column names with the order of history_row; docs/format.md gives units and definitions.
const std::vector<std::string>& history_columns();

std::vector<double> history_row(std::int64_t step, double time, const EnergyAccount& account, const StepSums& sums,
                                double gravitational, const BedState& bed, std::size_t particles);

}  // namespace packstone::engine
