// Work in units, shared out to processes: drawing keeps state that threads cannot share, and a process that dies takes
// nothing along.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viz/unit_answer.hpp"

namespace packstone::viz {

using UnitResult = std::vector<std::uint8_t>;

using DoUnit = std::function<UnitResult(std::size_t unit)>;

/// Units 0 ... count - 1, each of which any worker can do, more than once if need be.
struct WorkInUnits {
  std::size_t count = 0;
  std::string unit_name = "frame";  ///< for messages: "frame 3"
  std::string subject{};            ///< what the units are parts of; the same in all processes that share them
  std::size_t result_bytes = 0;     ///< expected of a result; a larger one takes a slower way
  /// Called once in every worker.
  std::function<DoUnit()> prepare;
  /// Called in this process in the order of the units.
  std::function<void(std::size_t unit, UnitResult result)> take;
  /// Called in this process now and then while it waits; ends the work by what it throws.
  std::function<void()> while_waiting{};
};

/// Workers that are there already, outside of this process and not its children.
class OutsideWorkers {
 public:
  virtual ~OutsideWorkers() = default;
  virtual std::size_t count() const = 0;
  /// Of a worker that has answered what it was given before.
  virtual void start(std::size_t worker, std::size_t unit) = 0;

  struct Report {
    std::size_t worker;
    Answer answer;
    UnitResult result;
  };
  /// The next answer that is there; nothing while there is none. Does not wait.
  virtual std::optional<Report> report() = 0;
};

/// Does all units by so many processes, forked from this one, which draw with one thread each; by this process alone
/// where there is one worker or one unit. A worker that dies is replaced and its unit done again. Throws what a worker
/// or take throws (InputError, RunError as such), and RunError when a unit's workers die three times or none can be
/// started; the workers are gone then. Workers outside share the units with at least one such process.
void do_units(const WorkInUnits& work, int workers, OutsideWorkers* outside = nullptr);

}  // namespace packstone::viz
