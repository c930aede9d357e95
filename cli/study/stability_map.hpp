// Maps of where models and steps fail: runs over two parameters, each judged as the monitor and the physics judge it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "core/snapshot.hpp"

namespace packstone::cli {

enum class Verdict {
  sound,
  disturbed,  ///< ran to its end, but not as the equations say
  stopped,    ///< by the monitor
  refused     ///< before the run
};

const char* to_string(Verdict verdict);

/// How one run of a map ended.
struct Outcome {
  Verdict verdict = Verdict::sound;
  std::string reason;       ///< what the monitor, the check before the run or the map's judge said
  double energy_error = 0;  ///< largest over the run, over the energy put in
  double kinetic = 0;       ///< at the end, over the sum of m g d; 0 without gravity
  double coordination = 0;  ///< at the end
  Snapshot last;
};

/// Runs the scene in memory. A run that the engine refuses or stops is an outcome.
Outcome outcome_of(const Scene& scene);

/// What is wrong with an energy account that is off by more than 2 % of what was put in; empty if nothing is.
std::string energy_trouble(const Outcome& outcome);

/// A line that theory draws into a map.
struct Limit {
  std::string name;  ///< formula and source
  std::function<double(double y)> x_at;
};

struct StabilityMap {
  std::string name, description;
  std::string x_label = "Time step over contact time";
  std::string y_label;
  std::vector<double> x, y;  ///< x on a logarithmic axis
  bool log_y = false;
  std::function<std::string(double x, double y)> scene;
  /// What is wrong with a run that came to its end; empty if nothing is.
  std::function<std::string(const Outcome&)> trouble = energy_trouble;
  std::vector<Limit> limits;
};

/// All maps; quick: every other column and row.
std::vector<StabilityMap> stability_maps(bool quick);

/// A point of a map.
struct MapPoint {
  double x, y;
  Outcome outcome;
};

MapPoint point_of(const StabilityMap& map, double x, double y);

}  // namespace packstone::cli
