// The scales of overdamped motion, and what they ask of an integrator.
#pragma once

#include <string>

#include "core/scene.hpp"
#include "engine/filling/population.hpp"
#include "engine/time_step.hpp"

namespace packstone::engine {

/// Natural scales of Revuzhenko, Klishin & Mikenina, Fiz. Mezomekh. 17 (2014), of the pair of groups that relaxes
/// fastest. Hertz' stiffness is the slope at the monitor's overlap limit, or under a bed's weight where that is known.
struct OverdampedScales {
  double contact_time = 0;     ///< t_0 = mu/k [s]
  double stiffness = 0;        ///< k [N/m]
  double stiffness_ratio = 0;  ///< chi = k r/weight; 0 without gravity
  double radius = 0;           ///< of the group's smallest particle [m]
  double sinking_speed = 0;    ///< of that particle, weight/mu [m/s]
  double single_limit = 0;     ///< explicit Euler's of one contact by itself [s]
  double bed_limit = 0;        ///< explicit Euler's in a bed, about [s]
  std::string pair;            ///< "beads - beads"
};

OverdampedScales overdamped_scales(const Scene& scene, const Population& population);

/// The scene's integrator, or the one that "auto" takes.
Integrator chosen_integrator(const Scene& scene);
const char* name_of(Integrator integrator);

/// As step_limit; contact_time is t_0.
StepLimit overdamped_step_limit(const OverdampedScales& scales);

/// Throws InputError where a given step is beyond the limit of one contact. Appends a warning beyond that of a bed.
void check_overdamped_step(const Scene& scene, const OverdampedScales& scales, std::vector<std::string>& warnings);

/// Time between two instants that the simulation looks at: the history's interval, or a whole part of that between
/// snapshots [s].
double look_interval(const Scene& scene);

}  // namespace packstone::engine
