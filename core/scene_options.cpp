// The one description of every key of a scene but those of [[boundary]], which boundary_options.cpp has.
#include <string>

#include <fmt/format.h>

#include "core/boundary_options.hpp"
#include "core/options.hpp"
#include "core/scene.hpp"
#include "core/scene_checks.hpp"

namespace packstone {

namespace {

using enum Presence;

const ChoiceNames output_fields = {"velocity",
                                   "angular_velocity",
                                   "force",
                                   "acceleration",
                                   "angular_acceleration",
                                   "mass",
                                   "full_radius",
                                   "moment_of_inertia",
                                   "kinetic_translational",
                                   "kinetic_rotational",
                                   "elastic",
                                   "gravitational"};
constexpr double most_particles = 5e8;  ///< of a group: what 32-bit entries of neighbour lists can refer to
const ChoiceNames dynamics_kinds = {"newtonian", "overdamped"};

void describe_rest(OptionVisitor& v, const std::string& what, std::optional<double>& speed, double& time,
                   std::optional<double>& force) {
  const std::string help = fmt::format(
      "Ends {} when the particles' root-mean-square speed, by mass, has been below this for rest_time, all being in",
      what);
  v.number({"rest_speed", help.c_str(), unit::speed, Range::positive()}, speed);
  v.number({"rest_time", "Goes with rest_speed; seen at each row of history.csv", unit::second, Range::positive()},
           time, has_default);
  const std::string force_help = fmt::format(
      "overdamped: ends {} when no particle's unbalanced force is more than this share of its weight (without gravity: "
      "of the mean contact force), all being in; seen at each row of history.csv",
      what);
  v.number({"rest_force", force_help.c_str(), unit::none, Range::positive()}, force);
}

void describe_resistance(OptionVisitor& v, const std::string& whose, ResistanceSpec& r) {
  const std::string constant = fmt::format("overdamped: resistance of {}, force over speed", whose);
  v.number({"viscosity", constant.c_str(), unit::damping, Range::positive()}, r.coefficient);
  const std::string stokes =
      fmt::format("overdamped, instead of viscosity: that of a fluid, nu; the resistance of {} is 6 pi r nu", whose);
  v.number({"stokes_viscosity", stokes.c_str(), unit::viscosity, Range::positive()}, r.fluid_viscosity);
}

void describe_stage(OptionVisitor& v, StageSpec& s) {
  v.text({"name", "Name that boundaries and motions refer to"}, s.name, required);
  v.number({"duration", "How long it lasts, at most", unit::second, Range::positive()}, s.duration, required);
  describe_rest(v, "the stage", s.rest_speed, s.rest_time, s.rest_force);
}

void describe_dynamics(OptionVisitor& v, DynamicsSpec& d) {
  v.choice({"kind",
            "Equations of motion. newtonian: Newton's. overdamped: no inertia, each particle's velocity is the force "
            "on it over its resistance; central forces alone"},
           dynamics_kinds, d.kind, has_default);
  v.number_or({"time_step",
               "Time step; \"auto\" takes the recommended share of the stiffest contact's duration, overdamped: "
               "chooses each step by tolerance",
               unit::second, Range::positive()},
              "auto", d.time_step);
  v.number({"duration", "Physical time to simulate, filling included; required, unless [[stage]] tables say it",
            unit::second, Range::positive()},
           d.duration, has_default);
  describe_rest(v, "the run", d.rest_speed, d.rest_time, d.rest_force);
  v.choice(
      {"contact_velocity",
       "Velocity that damping and friction see. step: of the step's instant, of second order. half-step: of half a "
       "step before, of first order in damping, stable to larger steps of a damped bed, exact for friction's springs. "
       "auto: half-step for linear contacts with friction or beyond the recommended time step, else step"},
      {"auto", "step", "half-step"}, d.contact_velocity, has_default);
  v.choice({"precision",
            "Of the forces between particles. mixed: single, from positions in fixed point; faster, with overlaps "
            "rounded by 1e-7 of the radii. Motion and walls are double either way"},
           {"double", "mixed"}, d.precision, has_default);
  v.number({"list_margin",
            "Way, over its radius, that each particle may go before all neighbours are sought anew; chosen by what the "
            "particles do unless given. Decides the cost alone, not the motion",
            unit::none, Range::above_up_to(0, 10)},
           d.list_margin);
  v.choice({"goal",
            "What the run is for. motion: how the particles move. rest: the bed at rest alone, by the cheapest way "
            "that keeps its statistics: a softened fall, then a balance of forces at full stiffness (docs/rest.md); "
            "ends the run"},
           {"motion", "rest"}, d.goal, has_default);
  v.number({"way_overlap",
            "goal = rest: overlap over radius that softer contacts may have under the bed's weight on the way; 0.002 "
            "unless given. Smaller is dearer and nearer to the motion's bed",
            unit::none, Range::above_up_to(0, 0.1)},
           d.way_overlap);
  v.number({"way_energy",
            "goal = rest, newtonian: kinetic energy, over the sum of the particles' m g d, at which the softened way "
            "ends; 0.005 unless given. overdamped: rest_force ends it, then of the mean unbalanced force over the mean "
            "weight; 0.05 unless given",
            unit::none, Range::above_up_to(0, 1)},
           d.way_energy);
  v.number({"unbalanced_force",
            "goal = rest: mean net force on a particle over the mean contact force at which the bed is at rest; 0.02 "
            "unless given",
            unit::none, Range::above_up_to(0, 1)},
           d.unbalanced_force);
  describe_resistance(v, "every particle", d.resistance);
  v.choice(
      {"integrator",
       "overdamped. euler: explicit, first order. rkc: explicit, stabilised (Runge-Kutta-Chebyshev), second order. "
       "implicit: backward Euler, first order, stable at any step, slower in beds. auto: rkc"},
      {"auto", "euler", "rkc", "implicit"}, d.integrator, has_default);
  v.number({"tolerance",
            "overdamped: error of one step in the particles' positions, root mean square over the mean radius; 0.01 "
            "unless given",
            unit::none, Range::above_up_to(0, 0.1)},
           d.tolerance);
}

void describe_domain(OptionVisitor& v, DomainSpec& d) {
  v.vector({"min", "Lower corner; goes with max", unit::metre}, d.min);
  v.vector({"max", "Upper corner", unit::metre}, d.max);
  v.number({"volume_factor", "Domain volume over the particles' solid volume, instead of min and max", unit::none,
            Range::positive()},
           d.volume_factor);
  v.vector({"aspect", "Ratio of the sides that goes with volume_factor; the lower corner is the origin", unit::none,
            Range::positive()},
           d.aspect);
  v.choices({"periodic", "Periodic axes"}, axes, d.periodic);
  v.choices({"open",
             "Faces through which particles may leave and come back, as an absent lid; through any other face "
             "that is not periodic a particle that leaves stops the run"},
            faces, d.open);
}

void describe_gravity(OptionVisitor& v, GravitySpec& g) {
  v.vector({"acceleration", "Acceleration", unit::acceleration}, g.acceleration, has_default);
  v.number({"start", "Time from which it acts", unit::second, Range::at_least(0)}, g.start, has_default);
  v.number({"end", "Time until which it acts; to the end unless given", unit::second, Range::positive()}, g.end);
  v.texts({"formula",
           "Three formulas in t [s] for its components over time, instead of acceleration, which still says "
           "where up is",
           unit::acceleration},
          g.formula);
}

void describe_van_der_waals(OptionVisitor& v, VanDerWaalsSpec& w) {
  v.number({"hamaker", "Hamaker constant A; the attraction is A R_eff / (6 h^2) at a gap h", unit::energy,
            Range::positive()},
           w.hamaker, required);
  v.number({"min_gap", "Gap at which the attraction stops growing; in contact it is what it is there", unit::metre,
            Range::positive()},
           w.min_gap, has_default);
  v.number({"cutoff", "Gap beyond which there is none; 100 min_gap unless given", unit::metre, Range::positive()},
           w.cutoff);
}

void describe_contact(OptionVisitor& v, ContactSpec& c) {
  v.choice({"normal", "Normal contact law"}, normal_laws, c.normal, required);
  v.choice({"tangential", "Tangential contact law"}, tangential_laws, c.tangential, has_default);
  v.choice(
      {"release",
       "End of a linear, hertz or kuwabara-kono contact: when the overlap is zero, or when the force would turn to "
       "a pull"},
      {"zero-overlap", "zero-force"}, c.release, has_default);
  v.number({"sign_speed",
            "hysteretic: the damping's sign is the rate of overlap over this speed, held within -1 and 1, so that a "
            "bed comes to rest; 0: it jumps",
            unit::speed, Range::at_least(0)},
           c.sign_speed, has_default);
  v.optional_table({"van_der_waals", "Attraction between surfaces; none when left out"}, c.van_der_waals.present,
                   [&] { describe_van_der_waals(v, c.van_der_waals); });
}

void describe_material(OptionVisitor& v, MaterialSpec& m) {
  const auto stiffness = [&](const char* key, const char* help, std::optional<double>& value) {
    v.number({key, help, unit::stiffness, Range::positive()}, value);
  };
  v.text({"name", "Name that particles and boundaries refer to"}, m.name, required);
  v.number({"density", "Density", unit::density, Range::positive()}, m.density, required);
  stiffness(
      "normal_stiffness",
      "Spring constant k_n of a contact of two such bodies, walton-braun: k_1 of first loading; needed by linear, "
      "walton-braun and hysteretic",
      m.normal_stiffness);
  stiffness("unloading_stiffness", "walton-braun: k_2 of unloading, at least normal_stiffness; or give restitution",
            m.unloading_stiffness);
  v.number({"young_modulus", "Young's modulus E; needed by hertz, kuwabara-kono and mindlin-deresiewicz",
            unit::pressure, Range::positive()},
           m.young_modulus);
  v.number({"poisson_ratio", "Poisson's ratio nu; needed with young_modulus", unit::none, Range::between(0, 0.5)},
           m.poisson_ratio);
  v.number({"normal_damping", "Damping: hysteretic a pure number g below 1, linear and hertz a coefficient in N s/m",
            unit::damping, Range::at_least(0)},
           m.normal_damping);
  v.number({"restitution",
            "Coefficient of restitution, instead of normal_damping or unloading_stiffness; the same at any speed",
            unit::none, Range::above_up_to(0, 1)},
           m.restitution);
  v.number({"dissipation_time", "kuwabara-kono: B; or give shear_viscosity and bulk_viscosity", unit::second,
            Range::at_least(0)},
           m.dissipation_time);
  v.number({"shear_viscosity", "kuwabara-kono: eta_1 of the material", unit::viscosity, Range::at_least(0)},
           m.shear_viscosity);
  v.number({"bulk_viscosity", "kuwabara-kono: eta_2 of the material", unit::viscosity, Range::at_least(0)},
           m.bulk_viscosity);
  stiffness("tangential_stiffness",
            "Spring constant k_s, walton-braun: K_0 of first loading; needed by cundall-strack and walton-braun",
            m.tangential_stiffness);
  v.number({"tangential_damping", "haff-werner, required: viscous coefficient g_s", unit::damping, Range::positive()},
           m.tangential_damping);
  v.number({"friction", "Coulomb friction coefficient", unit::none, Range::at_least(0)}, m.friction, has_default);
}

void describe_sizes(OptionVisitor& v, SizeSpec& s) {
  const auto number = [&](const char* key, const char* help, const Unit& unit, std::optional<double>& value) {
    v.number({key, help, unit, Range::positive()}, value);
  };
  v.choice({"distribution",
            "uniform between min and max; normal, lognormal or weibull, cut off at min and max; list: some radii; "
            "table: classes of sizes, as from sieves, evenly filled"},
           {"uniform", "normal", "lognormal", "weibull", "list", "table"}, s.distribution, required);
  v.choice({"by", "Whether the distribution is one of the number of particles or of their mass"}, {"number", "mass"},
           s.by, has_default);
  number("min",
         "uniform, required: smallest radius; normal, lognormal: 3 deviations down, weibull: the quantile 0.001, "
         "unless given",
         unit::metre, s.min);
  number("max", "Largest radius, likewise", unit::metre, s.max);
  number("mean", "normal, required: mean radius", unit::metre, s.mean);
  number("deviation", "normal, required: standard deviation", unit::metre, s.deviation);
  number("median", "lognormal, required: median radius", unit::metre, s.median);
  v.number({"spread", "lognormal, required: geometric standard deviation", unit::none, Range{1, 1e6, false, true}},
           s.spread);
  number("scale", "weibull, required: radius that 63 % are below", unit::metre, s.scale);
  number("shape", "weibull, required: exponent", unit::none, s.shape);
  v.numbers({"radii", "list, required: the radii; table, required: the ends of its classes; ascending", unit::metre,
             Range::positive()},
            s.radii);
  v.numbers({"shares", "Shares of the list's radii, equal unless given, or of the table's classes; any sum", unit::none,
             Range::at_least(0)},
            s.shares);
}

void describe_group(OptionVisitor& v, GroupSpec& g) {
  v.text({"name", "Name in legends and tables; the material's unless given"}, g.name, has_default);
  v.text({"material", "Name of a [[material]]"}, g.material, required);
  v.integer({"count", "Number of particles; required unless filling.kind is file, and then not given", unit::none,
             Range::between(1, most_particles)},
            g.count);
  v.number_or_table({"radius",
                     "Radius of all, or a table that says how radii are distributed; required unless filling.kind is "
                     "file, and then not given",
                     unit::metre, Range::positive()},
                    g.radius, g.sizes.present, [&] { describe_sizes(v, g.sizes); });
  describe_resistance(v, "the group's particles, instead of that in [dynamics]", g.resistance);
}

void describe_filling(OptionVisitor& v, FillingSpec& f) {
  v.choice(
      {"kind",
       "How the particles come in. growth: centres at random, radii grow from zero to full size. lattice: at rest on "
       "the sites of a lattice, from the bottom up, groups mixed at random. random: at rest at random places, "
       "without overlap. file: as a file has them. pour: over time, at random places of the region"},
      {"growth", "lattice", "random", "file", "pour"}, f.kind, required);
  v.number({"duration", "growth, required: time it takes", unit::second, Range::positive()}, f.duration);
  v.choice({"lattice", "lattice: simple cubic, body-centred, face-centred or hexagonal close packed"},
           {"cubic", "bcc", "fcc", "hcp"}, f.lattice, has_default);
  v.number(
      {"spacing",
       "lattice: distance of nearest sites, stretched where periodic sides ask for it; the largest diameter unless "
       "given",
       unit::metre, Range::positive()},
      f.spacing);
  v.vector({"region_min", "Lower corner of the region to fill; the domain's unless given; not with file", unit::metre},
           f.region_min);
  v.vector({"region_max", "Upper corner of the region to fill; not with file", unit::metre}, f.region_max);
  v.text({"path",
          "file, required: a CSV table, a LAMMPS data file (atom_style sphere, units si) or a packstone snapshot, told "
          "apart by content; relative to the scene file's folder. docs/format.md has the columns"},
         f.path);
  v.number({"rate", "pour: particles a second; or give portions", unit::frequency, Range::positive()}, f.rate);
  v.integer({"portions", "pour: number of equal portions, each when the one before has come to rest", unit::none,
             Range::at_least(1)},
            f.portions);
  v.number({"rest_speed", "pour with portions, required: root-mean-square speed below which a portion is at rest",
            unit::speed, Range::positive()},
           f.rest_speed);
  v.number({"rest_force",
            "pour with portions, overdamped, required instead of rest_speed: unbalanced force below which a portion is "
            "at rest, as in [dynamics]",
            unit::none, Range::positive()},
           f.rest_force);
  v.vector({"velocity", "pour: with which particles come in", unit::speed}, f.velocity, has_default);
  v.number({"most_mass", "pour: ends before the mass poured would be more", unit::mass, Range::positive()},
           f.most_mass);
  v.number({"fill_height", "pour: ends when the bed is as high", unit::metre, Range::positive()}, f.fill_height);
}

void describe_output(OptionVisitor& v, OutputSpec& o) {
  v.number({"interval", "Time between snapshots", unit::second, Range::positive()}, o.interval, required);
  v.choices({"fields", "Particle quantities to write beside position, radius, id, type and material"}, output_fields,
            o.fields);
  v.boolean({"contacts", "Whether snapshots hold the contacts and their forces"}, o.contacts);
  v.number({"history_interval", "Time between rows of history.csv", unit::second, Range::positive()},
           o.history_interval, has_default);
  v.number(
      {"checkpoint_interval",
       "Wall time between checkpoints, from which run --resume goes on; without it 600 s, or 100 times what one takes",
       unit::second, Range::positive()},
      o.checkpoint_interval);
}

void describe_monitor(OptionVisitor& v, MonitorSpec& m) {
  v.number({"overlap_limit", "Largest overlap allowed, as a share of the smaller full radius", unit::none,
            Range::above_up_to(0, 1)},
           m.overlap_limit, has_default);
  v.number({"energy_tolerance",
            "Largest rise of kinetic and elastic energy that nothing puts in, as a share of the "
            "energy put in so far",
            unit::none, Range::positive()},
           m.energy_tolerance, has_default);
}

}  // namespace

void describe(OptionVisitor& v, Scene& s) {
  v.text({"title", "Title of the run, shown in pictures and reports"}, s.title, has_default);
  v.integer({"seed", "Seed of every random stream", unit::none, Range::at_least(0)}, s.seed, has_default);
  v.table({"dynamics", "Motion and time"}, required, [&] { describe_dynamics(v, s.dynamics); });
  v.table({"domain", "The box that holds the particles' centres"}, required, [&] { describe_domain(v, s.domain); });
  v.optional_table({"gravity", "Gravity; none when left out"}, s.gravity.present,
                   [&] { describe_gravity(v, s.gravity); });
  v.table({"contact", "Contact laws"}, required, [&] { describe_contact(v, s.contact); });
  v.tables<MaterialSpec>({"material", "Materials of particles and boundaries"}, 1, s.materials, describe_material);
  v.tables<GroupSpec>({"particles", "Groups of particles; the number of a group is its type in the output"}, 1,
                      s.particles, describe_group);
  v.table({"filling", "How the particles come in"}, required, [&] { describe_filling(v, s.filling); });
  v.tables<BoundarySpec>({"boundary", "Walls"}, 0, s.boundaries, describe_boundary);
  v.tables<StageSpec>({"stage", "Parts of the run, one after the other"}, 0, s.stages, describe_stage);
  v.table({"output", "What the run folder holds"}, required, [&] { describe_output(v, s.output); });
  v.table({"monitor", "Limits at which a run that goes wrong is stopped"}, has_default,
          [&] { describe_monitor(v, s.monitor); });
}

}  // namespace packstone
