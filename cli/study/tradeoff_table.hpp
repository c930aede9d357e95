// Error against cost of the ways to do one thing.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/study/trials.hpp"

namespace packstone::cli {

/// The trials of one variant, one a seed.
struct VariantTrials {
  std::string label;
  std::string refused;  ///< why none was run; empty where they were
  std::vector<Trial> trials;
};

/// What an error is of. Seeds of runs are noise that a mean takes away; of measurements and pictures each is a result
/// of its own.
enum class Deviation {
  of_mean,  ///< absolute value of the mean difference from the reference
  of_one    ///< mean absolute difference
};

/// A quantity of one variant.
struct Accuracy {
  double mean = 0;
  double spread = 0;          ///< standard deviation over seeds
  double error = 0;           ///< see Deviation; differences from the reference are taken seed by seed
  double standard_error = 0;  ///< of that difference
  bool measured = false;      ///< error is above twice its standard error: more than noise

  /// Below its standard error an error is not known better than that.
  double known() const { return std::max(error, standard_error); }
  /// The error is below this unless noise hides it.
  double bound() const { return error + 2 * standard_error; }
};

/// One variant: what it costs and how far it is from the reference.
struct TradeoffRow {
  std::string label;
  std::string failure;        ///< of the first trial that failed, or why none was run; empty if all are well
  double seconds = 0;         ///< mean over the seeds
  double particle_steps = 0;  ///< mean over the seeds
  double memory = 0;          ///< largest over the seeds [B]; 0: not known
  std::map<std::string, Accuracy> accuracy;  ///< by quantity
  std::map<std::string, bool> on_front;      ///< by quantity: nothing cheaper has an error known to be as small
};

struct Tradeoff {
  std::string reference;
  std::vector<TradeoffRow> rows;             ///< in the variants' order
  std::map<std::string, std::string> units;  ///< by quantity

  /// Cheapest variant whose error is below the tolerance in every quantity that has one, two standard errors
  /// included; none where noise or error forbids it.
  const TradeoffRow* cheapest(const std::map<std::string, double>& tolerances) const;
};

/// reference: label; empty: the dearest that finished. Throws InputError when there is none, RunError when it failed.
Tradeoff tradeoff_of(const std::vector<VariantTrials>& variants, const std::vector<std::string>& quantities,
                     const std::string& reference, Deviation deviation = Deviation::of_mean);

}  // namespace packstone::cli
