// How a run's kinetic energy goes down.
#pragma once

#include "analysis/result.hpp"
#include "core/history.hpp"

namespace packstone::analysis {

/// Adds kinetic_peak, kinetic_peak_time, kinetic_decay_time and time_to_rest from history.csv. weight: sum of m g d
/// [J]; history: null where there is none.
void add_energy_decay(MeasureResult& result, const History* history, double weight);

}  // namespace packstone::analysis
