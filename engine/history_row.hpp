// One row of history.csv.
#pragma once

#include <string>
#include <vector>

#include "core/bed.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/monitor.hpp"

namespace packstone::engine {

/// Column names with the order of history_row; docs/format.md gives units and definitions.
std::vector<std::string> history_columns(const Scene& scene);

/// What a row is made of, at one instant.
struct HistorySources {
  std::int64_t step;
  double time;
  std::size_t stage;
  const EnergyAccount& account;
  const StepSums& sums;
  double gravitational;  ///< [J]
  const BedState& bed;
  std::size_t particles;
  const std::vector<WallLoad>& wall_loads;
  const Boundaries& boundaries;
  const IntegratorWork& work;
};

std::vector<double> history_row(const Scene& scene, const HistorySources& from);

}  // namespace packstone::engine
