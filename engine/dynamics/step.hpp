// One time step as the simulation sees it: what goes in, what comes out, and the interface that every combination of
// laws implements.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/archive.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/detection/neighbour_list.hpp"
#include "engine/dynamics/particles.hpp"

namespace packstone::engine {

/// What holds during one step.
struct StepInput {
  double dt = 0;  ///< [s]
  Growth growth;
  Vec3 gravity = Vec3::Zero();  ///< [m/s2]; zero before it starts
  double overlap_limit = 0;     ///< share of the smaller full radius
  /// By which the velocity that contacts see in the next step is ahead of the half step [s]; none where the particles
  /// were made for ContactVelocity::half_step.
  double velocity_lead = 0;
  /// Asked between the steps of an integrator that takes many: whether to pause there; null: it goes on.
  const std::function<bool()>* should_pause = nullptr;
  /// By which the velocity that contacts see is behind their positions [s].
  double velocity_lag() const { return 0.5 * dt - velocity_lead; }
};

/// A contact beyond the overlap limit.
struct Offence {
  std::int64_t first = 0;
  std::int64_t second = 0;  ///< particle, or -1-k for boundary k
  double overlap = 0;       ///< [m]

  void archive(Archive& a) { a(first, second, overlap); }
};

/// Sums over all particles; those marked (recorded) are only made in a recording step.
struct StepSums {
  double dissipated_normal = 0;      ///< by normal damping and plastic deformation [J]
  double dissipated_tangential = 0;  ///< by sliding [J]
  double dissipated_resistance = 0;  ///< against the resistance to overdamped motion [J]
  double growth_work = 0;            ///< of growing radii against contact forces [J]
  double gravity_work = 0;           ///< [J]
  double wall_work = 0;              ///< of moving boundaries on particles [J]
  double largest_share_squared = 0;  ///< of its list margin that a particle has used; infinite if not a number
  std::optional<Offence> offence;
  double kinetic_translational = 0;    ///< (recorded) [J]
  double kinetic_rotational = 0;       ///< (recorded) [J]
  double elastic = 0;                  ///< (recorded) stored in contacts [J]
  double attractive = 0;               ///< (recorded) potential of attraction, 0 or less [J]
  double largest_overlap_share = 0;    ///< (recorded) of the smaller full radius
  double largest_speed_squared = 0;    ///< (recorded) [m2/s2]
  std::int64_t particle_contacts = 0;  ///< (recorded) each pair once
  std::int64_t wall_contacts = 0;      ///< (recorded)
  double unbalanced_force = 0;         ///< (recorded) of overdamped motion, as its rest_force

  double dissipated() const { return dissipated_normal + dissipated_tangential + dissipated_resistance; }
  void add(const StepSums& other);

  void archive(Archive& a) {
    a(dissipated_normal, dissipated_tangential, dissipated_resistance, growth_work, gravity_work, wall_work,
      largest_share_squared, offence, kinetic_translational, kinetic_rotational, elastic, attractive,
      largest_overlap_share, largest_speed_squared, particle_contacts, wall_contacts, unbalanced_force);
  }
};

/// Per-particle results of a recording step by id, at the instant the step begins with.
struct Recorder {
  bool want_contacts = false;
  std::vector<Vec3> velocity;          ///< [m/s]
  std::vector<Vec3> angular_velocity;  ///< [rad/s]; empty where nothing turns
  std::vector<Vec3> force;             ///< contacts and gravity [N]
  /// [rad/s2]; empty where nothing turns or it is not wanted.
  std::vector<Vec3> angular_acceleration;
  /// Half of what each contact between particles stores, all of what walls' contacts do [J]; empty where not wanted.
  std::vector<double> elastic;
  Contacts contacts;
};

/// What overdamped motion has cost so far.
struct IntegratorWork {
  std::int64_t steps = 0;     ///< taken
  std::int64_t rejected = 0;  ///< made anew, shorter
  std::int64_t forces = 0;    ///< times that they were found

  void archive(Archive& a) { a(steps, rejected, forces); }

  IntegratorWork& operator+=(const IntegratorWork& o) {
    steps += o.steps;
    rejected += o.rejected;
    forces += o.forces;
    return *this;
  }
};

/// Equations of motion with one choice of laws.
class Dynamics {
 public:
  virtual ~Dynamics() = default;

  /// Builds the list anew, gives the particles new slots and carries contact history over. dt: of the coming steps [s].
  virtual void rebuild(Particles& particles, const Growth& growth, double dt) = 0;

  /// Forces at `now` and, where they set accelerations, motion into `next`. recorder, by id, may be null.
  virtual StepSums advance(Particles& particles, const StepInput& input, Recorder* recorder) = 0;

  /// Makes `now` the next instant, dt after a time [s]. What passed through on the way, where advance does not tell;
  /// nothing where it has paused: the same call goes on from there.
  virtual std::optional<StepSums> go_on(Particles& particles, const StepInput& input, double time) = 0;

  /// The time of `now` where go_on has paused [s].
  virtual std::optional<double> paused_at() const { return std::nullopt; }

  /// All that it keeps from step to step. Particles that were read belong to what is read here.
  virtual void archive(Archive& a, Particles& particles) = 0;

  /// Whether the list must be built anew before forces are right again, or a narrower one would pay.
  virtual bool outdated(const Growth& growth) const = 0;

  /// What the last step's instant did to each boundary.
  virtual const std::vector<WallLoad>& wall_loads() const = 0;

  virtual const NeighbourList& neighbours() const = 0;

  virtual IntegratorWork work() const { return {}; }
};

/// Combines the scene's laws once. The boundaries must outlive it. Friction that is zero everywhere costs nothing: no
/// rotation, no history.
std::unique_ptr<Dynamics> make_newtonian(const Scene& scene, const Domain& domain, const Boundaries& boundaries);

/// Whether particles turn: only friction turns a sphere.
bool rotates(const Scene& scene);

/// Whether the scene's laws are compiled into a loop of their own; the others share one.
bool has_own_loop(const Scene& scene);

}  // namespace packstone::engine
