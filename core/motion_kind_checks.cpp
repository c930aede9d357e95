// Keys that go with one kind of motion alone: nothing that a scene says is left aside without a word.
#include <string>

#include <fmt/format.h>

#include "core/scene_checks.hpp"

namespace packstone {

namespace {

const std::string leave_out = "; leave it out";

void refuse(const Scene& s, const std::string& path, bool given, const std::string& why) {
  if (given) s.fail(path, why);
}

void check_newtonian(const Scene& s) {
  const std::string why = "goes with dynamics.kind = \"overdamped\"" + leave_out;
  const DynamicsSpec& d = s.dynamics;
  refuse(s, "dynamics.viscosity", d.resistance.coefficient.has_value(), why);
  refuse(s, "dynamics.stokes_viscosity", d.resistance.fluid_viscosity.has_value(), why);
  refuse(s, "dynamics.integrator", d.integrator != Integrator::automatic, why);
  refuse(s, "dynamics.tolerance", d.tolerance.has_value(), why);
  refuse(s, "dynamics.rest_force", d.rest_force.has_value(), why + ", or take rest_speed");
  refuse(s, "filling.rest_force", s.filling.rest_force.has_value(), why + ", or take rest_speed");
  for (std::size_t k = 0; k < s.stages.size(); ++k) {
    refuse(s, fmt::format("stage[{}].rest_force", k), s.stages[k].rest_force.has_value(), why + ", or take rest_speed");
  }
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    const std::string path = fmt::format("particles[{}]", k);
    refuse(s, path + ".viscosity", s.particles[k].resistance.coefficient.has_value(), why);
    refuse(s, path + ".stokes_viscosity", s.particles[k].resistance.fluid_viscosity.has_value(), why);
  }
}

void check_resistances(const Scene& s) {
  const auto either = [&](const std::string& path, const ResistanceSpec& r) {
    refuse(s, path + ".stokes_viscosity", r.coefficient && r.fluid_viscosity,
           "is given beside viscosity; keep one of the two");
  };
  either("dynamics", s.dynamics.resistance);
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    const std::string path = fmt::format("particles[{}]", k);
    either(path, s.particles[k].resistance);
    if (s.dynamics.resistance.given() || s.particles[k].resistance.given()) continue;
    s.fail("dynamics",
           fmt::format("needs viscosity [N s/m] or stokes_viscosity [Pa s] for kind = \"overdamped\", unless "
                       "every group of particles has one; {} has none",
                       path));
  }
}

/// Rest is the balance of forces, which needs no time to be sure of.
void check_rest(const Scene& s) {
  const auto only_force = [&](const std::string& path, bool speed, double time) {
    const std::string why = "does not go with dynamics.kind = \"overdamped\", where rest is the balance of forces";
    refuse(s, path + ".rest_speed", speed, why + "; take rest_force");
    refuse(s, path + ".rest_time", time != DynamicsSpec{}.rest_time, why + leave_out);
  };
  only_force("dynamics", s.dynamics.rest_speed.has_value(), s.dynamics.rest_time);
  only_force("filling", s.filling.rest_speed.has_value(), DynamicsSpec{}.rest_time);
  for (std::size_t k = 0; k < s.stages.size(); ++k) {
    only_force(fmt::format("stage[{}]", k), s.stages[k].rest_speed.has_value(), s.stages[k].rest_time);
  }
}

/// Why a normal law is none of overdamped motion's; empty where it is.
std::string why_not(NormalModel law) {
  switch (law) {
    case NormalModel::hysteretic:
      return "hysteretic without its damping is \"linear\"; take that";
    case NormalModel::kuwabara_kono:
      return "kuwabara-kono without its damping is \"hertz\"; take that";
    case NormalModel::walton_braun:
      return "walton-braun's force depends on the largest overlap that there was, so that no energy tells where the "
             "bed rests; take \"linear\"";
    case NormalModel::linear:
    case NormalModel::hertz:
      break;
  }
  return "";
}

/// Central repulsion that is a function of the overlap alone.
void check_forces(const Scene& s) {
  const ContactSpec& c = s.contact;
  const std::string why = "does not go with dynamics.kind = \"overdamped\", ";
  refuse(s, "contact.normal", !why_not(c.normal).empty(),
         why + "where contacts are elastic and motion is resisted outside of them: " + why_not(c.normal));
  refuse(s, "contact.tangential", c.tangential != TangentialModel::none,
         why + "whose forces are central: particles neither turn nor rub" + leave_out);
  refuse(s, "contact.van_der_waals", c.van_der_waals.present, why + "whose contacts only repel" + leave_out);
  refuse(s, "contact.release", c.release != Release::zero_overlap, why + "whose contacts have no damping" + leave_out);
  for (std::size_t k = 0; k < s.materials.size(); ++k) {
    const MaterialSpec& m = s.materials[k];
    const std::string path = fmt::format("material[{}]", k);
    refuse(s, path + ".restitution", m.restitution.has_value(), why + "whose contacts have no damping" + leave_out);
    refuse(s, path + ".normal_damping", m.normal_damping.value_or(0) > 0,
           why + "whose contacts have no damping" + leave_out);
    refuse(s, path + ".friction", m.friction > 0, why + "whose forces are central" + leave_out);
  }
}

void check_overdamped(const Scene& s) {
  const DynamicsSpec& d = s.dynamics;
  const std::string why = "does not go with dynamics.kind = \"overdamped\", ";
  check_resistances(s);
  check_forces(s);
  check_rest(s);
  refuse(s, "dynamics.contact_velocity", d.contact_velocity != ContactVelocity::automatic,
         why + "whose contacts see no velocity" + leave_out);
  refuse(s, "dynamics.list_margin", d.list_margin.has_value(),
         why + "whose steps, and lists with them, go by how far particles come" + leave_out);
  refuse(s, "dynamics.precision", d.precision != Precision::double_precision,
         why + "whose balance of forces takes double precision" + leave_out);
  refuse(
      s, "dynamics.time_step", d.time_step && d.integrator == Integrator::automatic,
      "is given beside integrator = \"auto\", which needs to choose its steps; leave it out, or name the integrator");
  refuse(s, "filling.velocity", !s.filling.velocity.isZero(0), why + "where forces set velocities" + leave_out);
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    refuse(s, fmt::format("boundary[{}].motion", k), s.boundaries[k].motion.free,
           why + "where a free body's mass would be the only inertia; give its displacement or hold it");
  }
}

void check_goal_of_motion(const Scene& s) {
  const DynamicsSpec& d = s.dynamics;
  const std::string why = "goes with dynamics.goal = \"rest\"" + leave_out;
  refuse(s, "dynamics.way_overlap", d.way_overlap.has_value(), why);
  refuse(s, "dynamics.way_energy", d.way_energy.has_value(), why);
  refuse(s, "dynamics.unbalanced_force", d.unbalanced_force.has_value(), why);
}

/// Under constant gravity, between walls that stand still, of contacts that softening changes in scale alone.
void check_goal_of_rest(const Scene& s) {
  const std::string why = "does not go with dynamics.goal = \"rest\", ";
  refuse(s, "dynamics.way_energy", s.dynamics.overdamped() && s.dynamics.way_energy.has_value(),
         "does not go with dynamics.kind = \"overdamped\", which has no kinetic energy; take rest_force");
  refuse(s, "gravity", !s.gravity.present, "is needed for dynamics.goal = \"rest\": without it nothing makes a bed");
  refuse(s, "gravity.end", s.gravity.end.has_value(), why + "whose bed lies under gravity" + leave_out);
  refuse(s, "gravity.formula", !s.gravity.formula.empty(), why + "whose bed lies under constant gravity" + leave_out);
  refuse(s, "stage", !s.stages.empty(), why + "which has one end: the bed at rest");
  refuse(s, "contact.van_der_waals", s.contact.van_der_waals.present,
         why + "since softer contacts would stick more; take goal = \"motion\"");
  refuse(s, "contact.normal", s.contact.normal == NormalModel::walton_braun,
         why + "since these contacts keep the largest overlap that they had on the way; take goal = \"motion\"");
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    refuse(s, fmt::format("boundary[{}].motion", k), s.boundaries[k].motion.present,
           why + "whose walls stand still; take goal = \"motion\"");
  }
}

}  // namespace

void check_motion_kind(const Scene& scene) {
  scene.dynamics.goal == Goal::rest ? check_goal_of_rest(scene) : check_goal_of_motion(scene);
  scene.dynamics.overdamped() ? check_overdamped(scene) : check_newtonian(scene);
}

}  // namespace packstone
