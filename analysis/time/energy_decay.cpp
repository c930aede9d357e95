#include "analysis/time/energy_decay.hpp"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "analysis/time/rest.hpp"

namespace packstone::analysis {

namespace {

struct DecayQuantities {
  Quantity peak{.key = "kinetic_peak",
                .label = "largest kinetic energy",
                .unit = "J",
                .definition = "largest kinetic energy, translation and rotation, of a row of history.csv"};
  Quantity peak_time{.key = "kinetic_peak_time",
                     .label = "time of the largest kinetic energy",
                     .unit = "s",
                     .definition = "time of kinetic_peak"};
  Quantity decay{.key = "kinetic_decay_time",
                 .label = "time in which the kinetic energy falls to 1/e",
                 .unit = "s",
                 .definition =
                     "from kinetic_peak_time to the first row from which on the kinetic energy stays below "
                     "kinetic_peak / e"};
  Quantity rest{.key = "time_to_rest",
                .label = "time of rest",
                .unit = "s",
                .definition = fmt::format("time of the first row of history.csv from which on the kinetic energy, "
                                          "translation and rotation, stays below {:g} of the sum of m g d",
                                          rest_threshold)};
};

/// First row from which on all values are below a limit; the number of rows when the last is not.
std::size_t below_for_good(const std::vector<double>& values, double limit) {
  std::size_t row = values.size();
  while (row > 0 && values[row - 1] < limit) --row;
  return row;
}

void fill(DecayQuantities& q, const std::vector<double>& time, const std::vector<double>& kinetic, double weight) {
  const auto peak = static_cast<std::size_t>(std::max_element(kinetic.begin(), kinetic.end()) - kinetic.begin());
  if (!(kinetic[peak] > 0)) {
    for (Quantity* each : {&q.peak, &q.peak_time, &q.decay, &q.rest}) *each = not_applicable(*each, "nothing moved");
    return;
  }
  q.peak.value = kinetic[peak];
  q.peak_time.value = time[peak];
  const std::size_t decayed = below_for_good(kinetic, kinetic[peak] / std::numbers::e);
  if (decayed < time.size()) {
    q.decay.value = time[decayed] - time[peak];
  } else {
    q.decay = not_applicable(q.decay, "the kinetic energy has not fallen that far");
  }
  const std::size_t rested = below_for_good(kinetic, rest_threshold * weight);
  if (!(weight > 0)) {
    q.rest = not_applicable(q.rest, "no gravity or no mass to compare with");
  } else if (rested < time.size()) {
    q.rest.value = time[rested];
  } else {
    q.rest = not_applicable(q.rest, "not at rest at the end");
  }
}

}  // namespace

void add_energy_decay(MeasureResult& result, const History* history, double weight) {
  DecayQuantities q;
  if (history == nullptr || history->rows() == 0) {
    for (Quantity* each : {&q.peak, &q.peak_time, &q.decay, &q.rest}) {
      *each = not_applicable(*each, "there is no history.csv beside the snapshots");
    }
  } else {
    std::vector<double> kinetic = history->column("kinetic_translational");
    const std::vector<double>& rotational = history->column("kinetic_rotational");
    for (std::size_t row = 0; row < kinetic.size(); ++row) kinetic[row] += rotational[row];
    fill(q, history->column("time"), kinetic, weight);
  }
  for (const Quantity& each : {q.peak, q.peak_time, q.decay, q.rest}) result.quantities.push_back(each);
}

}  // namespace packstone::analysis
