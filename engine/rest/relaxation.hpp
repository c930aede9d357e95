// The nearest balance of central forces, by fast inertial relaxation: Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201,
// as Guenole et al., Comput. Mater. Sci. 175 (2020) 109584 have it.
#pragma once

#include <cstdint>
#include <functional>

#include "core/scene.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

/// How nearly forces are in balance.
struct ForceBalance {
  double unbalanced = 0;           ///< mean net force on a particle over the mean contact force
  double largest_over_weight = 0;  ///< largest net force on a particle over its weight
};

/// Steps and what they took.
struct StepWork {
  std::int64_t steps = 0, list_builds = 0;
  double loop_seconds = 0;  ///< lists of neighbours included
  double list_seconds = 0;

  StepWork& operator+=(const StepWork& o) {
    steps += o.steps;
    list_builds += o.list_builds;
    loop_seconds += o.loop_seconds;
    list_seconds += o.list_seconds;
    return *this;
  }
};

struct Relaxation {
  ForceBalance balance;
  StepWork work;
};

struct RelaxationLimits {
  double unbalanced = 0;        ///< at which particles are at rest
  std::int64_t most_steps = 0;  ///< after which they are left as they are
  double overlap = 0;           ///< share of the smaller radius
};

/// Whether relax knows the scene's forces: linear, hysteretic, hertz and kuwabara-kono contacts without friction or
/// attraction, whose elastic part is central and a function of the overlap alone.
bool can_relax(const Scene& scene);

/// Moves particles downhill in elastic and gravitational energy until their forces balance; velocities end at 0.
/// Nothing is lost by what moves them: neither contact law nor inertia changes where forces balance. should_stop: may
/// be empty; asked now and then, throws Interrupted. Throws RunFailure when an overlap is beyond its limit at the end;
/// the state is told all the same.
Relaxation relax(const Scene& scene, StartingState& state, const RelaxationLimits& limits,
                 const std::function<bool()>& should_stop);

}  // namespace packstone::engine
