#include "cli/study/tradeoff_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

/// Mean and standard deviation; 0 of a single value.
std::pair<double, double> mean_and_spread(const std::vector<double>& values) {
  double sum = 0, squared = 0;
  for (const double v : values) sum += v;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) squared += (v - sum / n) * (v - sum / n);
  return {sum / n, values.size() > 1 ? std::sqrt(squared / (n - 1)) : 0};
}

bool all_finished(const VariantTrials& variant) {
  return variant.refused.empty() && !variant.trials.empty() &&
         std::all_of(variant.trials.begin(), variant.trials.end(), [](const Trial& t) { return t.finished; });
}

double seconds_of(const VariantTrials& variant) {
  double sum = 0;
  for (const Trial& trial : variant.trials) sum += trial.seconds;
  return sum / static_cast<double>(std::max<std::size_t>(variant.trials.size(), 1));
}

const VariantTrials& chosen_reference(const std::vector<VariantTrials>& variants, const std::string& label) {
  const VariantTrials* chosen = nullptr;
  std::vector<std::string> labels;
  for (const VariantTrials& variant : variants) {
    labels.push_back("\"" + variant.label + "\"");
    if (label.empty() ? all_finished(variant) && (!chosen || seconds_of(variant) > seconds_of(*chosen))
                      : variant.label == label) {
      chosen = &variant;
    }
  }
  if (!chosen && label.empty()) throw RunError("no variant finished, so that there is nothing to compare with");
  if (!chosen) throw InputError(fmt::format("--reference: no variant \"{}\"; there are {}", label, joined(labels)));
  if (!all_finished(*chosen)) {
    throw RunError(fmt::format("the reference \"{}\" did not finish; name another with --reference", label));
  }
  return *chosen;
}

/// Seeds are the same in both, so that what they share in common falls out of the difference.
std::optional<Accuracy> accuracy_of(const VariantTrials& variant, const VariantTrials& reference,
                                    const std::string& quantity, Deviation deviation) {
  std::vector<double> values, differences;
  for (std::size_t k = 0; k < variant.trials.size(); ++k) {
    const auto value = variant.trials[k].values.find(quantity);
    const auto true_value = reference.trials[k].values.find(quantity);
    if (value == variant.trials[k].values.end() || true_value == reference.trials[k].values.end()) return std::nullopt;
    values.push_back(value->second);
    const double off = value->second - true_value->second;
    differences.push_back(deviation == Deviation::of_one ? std::abs(off) : off);
  }
  Accuracy accuracy;
  std::tie(accuracy.mean, accuracy.spread) = mean_and_spread(values);
  const auto [difference, spread] = mean_and_spread(differences);
  accuracy.error = std::abs(difference);
  accuracy.standard_error = spread / std::sqrt(static_cast<double>(values.size()));
  accuracy.measured = values.size() > 1 && accuracy.error > 2 * accuracy.standard_error;
  return accuracy;
}

void mark_front(std::vector<TradeoffRow>& rows, const std::string& quantity) {
  for (TradeoffRow& row : rows) {
    const auto own = row.accuracy.find(quantity);
    if (own == row.accuracy.end()) continue;
    row.on_front[quantity] = std::none_of(rows.begin(), rows.end(), [&](const TradeoffRow& other) {
      const auto its = other.accuracy.find(quantity);
      return its != other.accuracy.end() && other.seconds < row.seconds && its->second.known() <= own->second.known();
    });
  }
}

TradeoffRow row_of(const VariantTrials& variant, const VariantTrials& reference,
                   const std::vector<std::string>& quantities, Deviation deviation) {
  TradeoffRow row;
  row.label = variant.label;
  row.failure = variant.refused;
  for (const Trial& trial : variant.trials) {
    if (!trial.finished && row.failure.empty()) row.failure = trial.reason;
    row.particle_steps += trial.particle_steps / static_cast<double>(variant.trials.size());
    row.memory = std::max(row.memory, trial.memory);
  }
  row.seconds = seconds_of(variant);
  if (!all_finished(variant)) return row;
  for (const std::string& quantity : quantities) {
    if (const auto accuracy = accuracy_of(variant, reference, quantity, deviation)) row.accuracy[quantity] = *accuracy;
  }
  return row;
}

}  // namespace

Tradeoff tradeoff_of(const std::vector<VariantTrials>& variants, const std::vector<std::string>& quantities,
                     const std::string& reference, Deviation deviation) {
  const VariantTrials& truth = chosen_reference(variants, reference);
  Tradeoff result;
  result.reference = truth.label;
  result.units = truth.trials.front().units;
  for (const VariantTrials& variant : variants) result.rows.push_back(row_of(variant, truth, quantities, deviation));
  for (const std::string& quantity : quantities) mark_front(result.rows, quantity);
  return result;
}

const TradeoffRow* Tradeoff::cheapest(const std::map<std::string, double>& tolerances) const {
  const TradeoffRow* best = nullptr;
  for (const TradeoffRow& row : rows) {
    const bool good = std::all_of(tolerances.begin(), tolerances.end(), [&](const auto& asked) {
      const auto found = row.accuracy.find(asked.first);
      return found != row.accuracy.end() && found->second.bound() <= asked.second;
    });
    if (good && (!best || row.seconds < best->seconds)) best = &row;
  }
  return best;
}

}  // namespace packstone::cli
