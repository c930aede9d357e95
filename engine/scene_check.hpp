// What a scene would run, told before it does: numbers that follow from its keys, cost, advice.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/contact/head_on.hpp"
#include "engine/overdamped_scales.hpp"
#include "engine/rest/softening.hpp"
#include "engine/simplifications.hpp"
#include "engine/time_step.hpp"

namespace packstone::engine {

/// One kind of contact: two groups, or a group and a boundary; of each group its smallest particle.
struct PairCheck {
  std::string pair;           ///< "light - heavy", "light - floor"
  double effective_mass = 0;  ///< [kg]
  Impact impact;              ///< at the scene's reference speed
  double overlap_share = 0;   ///< the impact's largest overlap over the smaller radius
  double steps = 0;           ///< of the run in the impact's duration
};

struct SceneCheck {
  std::int64_t particles = 0;
  double mass = 0;           ///< of all particles [kg]
  double solid_volume = 0;   ///< [m3]
  Vec3 size = Vec3::Zero();  ///< of the domain [m]

  double time_step = 0;  ///< [s]
  StepLimit limit;
  std::int64_t steps = 0;

  /// Of overdamped motion, whose steps are looks of the simulation and whose time_step is between two of them.
  std::optional<OverdampedScales> overdamped;
  std::string integrator;      ///< the one that runs, and why
  double reference_speed = 0;  ///< of a fall through the domain, or of growing radii [m/s]
  std::vector<PairCheck> pairs;
  /// Overlap at the bottom of the bed, a column's weight on one contact, over the radius; none without gravity.
  std::optional<double> resting_overlap;
  /// Of the smallest particle: attraction in contact over weight, and the speed below which it sticks [m/s].
  std::optional<double> bond_number, sticking_speed;

  double memory = 0;  ///< of the engine, about [bytes]
  std::int64_t snapshots = 0;
  double disk = 0;     ///< of all snapshots, about [bytes]
  double seconds = 0;  ///< of the steps on two cores of the machine of docs/performance.md, about [s]

  /// Of dynamics.goal = "rest": how soft the way is, and its step [s].
  std::optional<Softening> way;
  double way_step = 0;

  std::vector<std::string> warnings;            ///< what a run would warn of
  std::vector<std::string> advice;              ///< what to change, lest the run goes wrong or waits for nothing
  std::vector<Simplification> simplifications;  ///< what the scene could do without, or do cheaper
};

/// Of the snapshots' bytes, those that contacts take, about.
double disk_of_contacts(const Scene& scene, const SceneCheck& check);

/// Throws InputError where a run would.
SceneCheck check_scene(const Scene& scene);

}  // namespace packstone::engine
