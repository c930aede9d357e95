// Why a run was stopped, or is not to be trusted, in parts that people and programs read: docs/reliability.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/vec3.hpp"

namespace packstone {

enum class FailureKind {
  not_a_number,
  particle_too_fast,
  particle_lost,
  wall_crossed,
  overlap,
  boundary_too_fast,
  energy_growth,
  overdamped_instability,
  step_too_long,
  non_convergence,
  filling_incomplete,
  formula_not_a_number,
  account_open
};

/// As in run.json, "not-a-number".
const char* to_string(FailureKind kind);
/// Throws InputError.
FailureKind failure_kind_named(const std::string& name);

struct NamedParticle {
  std::int64_t id;
  std::string group;

  bool operator==(const NamedParticle&) const = default;
};

/// For messages: "particle 3 (light)".
std::string told(const NamedParticle& particle);
/// For messages: "(0.1, 0.02, 0.3) m".
std::string told(const Vec3& place);

/// A key of the scene to change.
struct Remedy {
  std::string key;      ///< "dynamics.time_step"
  std::string value{};  ///< that would do, as --set takes it; empty where only the direction is known

  bool operator==(const Remedy&) const = default;
};

struct RunVerdict {
  FailureKind kind = FailureKind::not_a_number;
  std::optional<double> time{};  ///< [s]
  std::optional<std::int64_t> step{};
  std::vector<NamedParticle> particles{};  ///< the offenders, the worst first; none where nobody in particular is
  std::vector<NamedParticle> touching{};   ///< that are in contact with one of those, and not among them
  std::vector<std::string> boundaries{};   ///< that offend, or touch an offender
  std::optional<Vec3> place{};             ///< of the first offender, where it is known [m]
  std::string quantity{};                  ///< that is beyond its limit: "overlap over the smaller radius"
  double value = 0;                        ///< of it; may be infinite or not a number
  double limit = 0;
  std::string unit{};              ///< of both, SI; empty for a pure number
  std::string what{};              ///< the finding, with names and numbers
  std::string cause{};             ///< likely; empty where what says it
  std::string advice{};            ///< what to change
  std::vector<Remedy> remedies{};  ///< the same by keys, the likeliest first; any one of them

  /// In one line.
  std::string message() const;
};

/// A run that had to be stopped.
class RunFailure : public RunError {
 public:
  explicit RunFailure(RunVerdict verdict) : RunError(verdict.message()), verdict_(std::move(verdict)) {}
  const RunVerdict& verdict() const { return verdict_; }

 private:
  RunVerdict verdict_;
};

}  // namespace packstone
