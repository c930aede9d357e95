// What a run's numbers say, in words.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.hpp"
#include "core/run_folder.hpp"

namespace packstone::cli {

/// The measures of the two instants a report speaks of.
struct ReportedMeasures {
  bool filling_over = false;                    ///< whether the run got that far; if not, filled is the last snapshot
  double filled_time = 0;                       ///< when the filling was over [s]
  std::vector<analysis::MeasureResult> filled;  ///< then
  double end_time = 0;                          ///< [s]
  std::vector<analysis::MeasureResult> end;     ///< at the last snapshot
};

/// The quantity of a measure; throws RunError when the measures lack it.
const analysis::Quantity& quantity(const std::vector<analysis::MeasureResult>& results, const std::string& measure,
                                   const std::string& key);

/// A sentence or two each: rest, packing, segregation, layers, clusters, energy account.
std::vector<std::string> findings(const RunReader& run, const ReportedMeasures& measures);

}  // namespace packstone::cli
