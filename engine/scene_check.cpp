#include "engine/scene_check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/contact/van_der_waals.hpp"
#include "engine/contact_loads.hpp"
#include "engine/contact_pairs.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/rest/relaxation.hpp"
#include "engine/rest/rest_run.hpp"
#include "engine/simulation.hpp"

namespace packstone::engine {

namespace {

// Peak memory and speed, docs/performance.md: bytes a particle, particle-steps a second on two cores.
constexpr double bytes_a_particle = 550, bytes_with_friction = 1100;
constexpr double rate_frictionless = 25e6, rate_with_friction = 10e6, rate_of_other_laws = 6e6;
constexpr double bytes_in_a_snapshot = 52, bytes_of_a_vector = 24, bytes_of_a_contact = 105, contacts_a_particle = 3;

double gravity_of(const Scene& scene) { return scene.gravity.present ? scene.gravity.acceleration.norm() : 0; }

double reference_speed(const Scene& scene, const SceneCheck& check, const std::vector<SmallestParticle>& bodies) {
  if (gravity_of(scene) > 0) return fall_speed(scene, check.size);
  const double radius = bodies.empty() ? 0 : bodies.front().radius;
  return scene.filling.over() > 0 ? 2 * radius / scene.filling.over() : 1;
}

void check_pairs(const Scene& scene, const Population& population, SceneCheck& check) {
  for (const ContactPair& pair : contact_pairs(scene, population)) {
    const Impact impact = impact_of(scene, *pair.a, *pair.b, pair.size, check.reference_speed);
    check.pairs.push_back({pair.name, pair.effective_mass(), impact, impact.largest_overlap / pair.smaller_radius,
                           impact.duration / check.time_step});
  }
}

void check_attraction(const Scene& scene, const std::vector<SmallestParticle>& bodies, SceneCheck& check) {
  if (!scene.contact.van_der_waals.present || bodies.empty()) return;
  const SmallestParticle& smallest =
      *std::min_element(bodies.begin(), bodies.end(), [](const auto& a, const auto& b) { return a.radius < b.radius; });
  const VanDerWaals law(scene.contact.van_der_waals);
  const double radius = 0.5 * smallest.radius;
  if (gravity_of(scene) > 0) check.bond_number = law.force(radius, 0.0) / (smallest.mass * gravity_of(scene));
  const PairSize<double> size{2 / smallest.mass, radius};
  const double e = impact_of(scene, *smallest.material, *smallest.material, size, check.reference_speed).restitution;
  // Falling in adds what climbing out takes; the rebound keeps e^2 of both.
  const double well = -law.energy(radius, 0.0);
  check.sticking_speed =
      e > 0 ? std::sqrt(2 * well * (1 / (e * e) - 1) * size.inverse_mass_sum) : check.reference_speed;
}

void check_cost(const Scene& scene, SceneCheck& check) {
  const auto n = static_cast<double>(check.particles);
  const bool friction = rotates(scene);
  check.memory = n * (friction ? bytes_with_friction : bytes_a_particle);
  const double rate = !has_own_loop(scene) ? rate_of_other_laws : friction ? rate_with_friction : rate_frictionless;
  if (check.way && !check.overdamped) {
    check.seconds = n * scene.dynamics.duration / check.way_step / rate;
  } else if (!check.overdamped) {
    check.seconds = n * static_cast<double>(check.steps) / rate;
  }
  check.snapshots = 1 + std::llround(std::floor(scene.dynamics.duration / scene.output.interval * (1 + 1e-12)));
  double bytes = bytes_in_a_snapshot + bytes_of_a_vector * static_cast<double>(scene.output.fields.size());
  check.disk = n * bytes * static_cast<double>(check.snapshots) + disk_of_contacts(scene, check);
}

/// Which integrator runs, and whether it is looked at too often.
void check_overdamped(const Scene& scene, SceneCheck& check) {
  const OverdampedScales& scales = *check.overdamped;
  check.integrator = name_of(chosen_integrator(scene));
  if (scene.dynamics.integrator == Integrator::automatic) {
    check.integrator += ", by auto: as many stages as the stiffness asks for, the quickest in every bed measured";
  }
  const double look_distance = check.time_step * scales.sinking_speed;
  constexpr double wanted_distance = 0.2;  // radii
  const double radius = scales.radius;
  if (scales.sinking_speed > 0 && look_distance < 0.1 * wanted_distance * radius) {
    check.advice.push_back(
        fmt::format("output.history_interval: a free sphere sinks only {:.2g} of its radius in {:.3g} s, and no step "
                    "is longer; {:.3g} "
                    "s would let steps grow",
                    look_distance / radius, check.time_step, wanted_distance * radius / scales.sinking_speed));
  }
}

const char* stiffness_key(const Scene& scene) {
  return is_hertzian(scene.contact.normal) ? "young_modulus" : "normal_stiffness";
}

void advise(const Scene& scene, SceneCheck& check) {
  double deepest = check.resting_overlap.value_or(0);
  for (const PairCheck& pair : check.pairs) deepest = std::max(deepest, pair.overlap_share);
  if (deepest > scene.monitor.overlap_limit) {
    check.advice.push_back(fmt::format(
        "overlaps of up to {:.2g} % of the radius are to be expected, beyond monitor.overlap_limit = {:g} %: raise {}",
        100 * deepest, 100 * scene.monitor.overlap_limit, stiffness_key(scene)));
  }
}

/// What softening leaves to say.
void advise_on_rest(const Scene& scene, SceneCheck& check) {
  if (check.resting_overlap.value_or(0) > scene.monitor.overlap_limit) {
    check.advice.push_back(
        fmt::format("overlaps of up to {:.2g} % of the radius are to be expected at rest, beyond "
                    "monitor.overlap_limit = {:g} %: raise {}",
                    100 * *check.resting_overlap, 100 * scene.monitor.overlap_limit, stiffness_key(scene)));
  }
  if (!can_relax(scene)) {
    check.advice.push_back(
        "dynamics.goal: friction keeps what happened on the way, so that rest is reached by the "
        "scene's own motion at full stiffness; only the way down is cheaper");
  }
}

}  // namespace

double disk_of_contacts(const Scene& scene, const SceneCheck& check) {
  if (!scene.output.contacts) return 0;
  return bytes_of_a_contact * contacts_a_particle * static_cast<double>(check.particles) *
         static_cast<double>(check.snapshots);
}

SceneCheck check_scene(const Scene& scene) {
  const Simulation simulation(scene);
  SceneCheck check;
  if (scene.dynamics.goal == Goal::rest) {
    check.way = softening(scene, simulation.population(), simulation.solid_volume());
    check.way_step = way_step(scene, *check.way, simulation.step_limit());
  }
  check.particles = simulation.particle_count();
  check.size = simulation.scene().box().size();
  check.overdamped = simulation.overdamped();
  check.time_step = check.overdamped ? look_interval(scene) : *simulation.scene().dynamics.time_step;
  check.limit = simulation.step_limit();
  check.steps = simulation.steps();
  check.warnings = simulation.warnings();
  check.mass = simulation.total_mass();
  check.solid_volume = simulation.solid_volume();
  const std::vector<SmallestParticle> bodies = smallest_particles(scene, simulation.population());
  if (check.overdamped) {
    check_overdamped(scene, check);
  } else {
    check.reference_speed = reference_speed(scene, check, bodies);
    check_pairs(scene, simulation.population(), check);
  }
  if (gravity_of(scene) > 0 && !bodies.empty()) {
    check.resting_overlap = resting_overlap(scene, simulation.population(), check.size, check.solid_volume);
  }
  check_attraction(scene, bodies, check);
  check_cost(scene, check);
  check.way ? advise_on_rest(scene, check) : advise(scene, check);
  check.simplifications = simplifications(scene, simulation, check);
  return check;
}

}  // namespace packstone::engine
