// The scene: what is to be simulated, as the user wrote it, every default filled in. docs/scene.md is generated from
// the same descriptions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/boundary_spec.hpp"
#include "core/domain.hpp"
#include "core/options.hpp"
#include "core/size_distribution.hpp"
#include "core/vec3.hpp"

namespace packstone {

enum class NormalModel { linear, hertz, kuwabara_kono, walton_braun, hysteretic };
enum class TangentialModel { none, coulomb, haff_werner, cundall_strack, mindlin_deresiewicz, walton_braun };
/// Whether the elastic force is that of Hertz' spheres, given by their moduli.
inline bool is_hertzian(NormalModel law) { return law == NormalModel::hertz || law == NormalModel::kuwabara_kono; }
/// When a contact with a damped normal force is over: with the overlap, or as soon as the force would pull.
enum class Release { zero_overlap, zero_force };
enum class FillingKind { growth, lattice, random, file, pour };
enum class Lattice { cubic, bcc, fcc, hcp };

/// Faces of the domain through which particles may leave and come back.
enum Face { x_min, x_max, y_min, y_max, z_min, z_max, face_count };

/// Velocity that damping and friction see: that of the step's instant, of second order; that of half a step before, of
/// first order, but stable to larger steps of a damped bed; or whichever suits the step.
enum class ContactVelocity { automatic, step, half_step };
enum class Precision { double_precision, mixed };

/// Newton's equations, or motion without inertia, in which forces set velocities.
enum class MotionKind { newtonian, overdamped };
/// What a run is for: the motion itself, or the bed at rest alone (docs/rest.md).
enum class Goal { motion, rest };
/// Of overdamped motion (docs/overdamped.md).
enum class Integrator { automatic, euler, rkc, implicit };

/// Resistance to overdamped motion: one coefficient for every particle, or Stokes' 6 pi r nu.
struct ResistanceSpec {
  std::optional<double> coefficient;      ///< [N s/m]
  std::optional<double> fluid_viscosity;  ///< nu [Pa s]

  bool given() const { return coefficient || fluid_viscosity; }
};

struct DynamicsSpec {
  MotionKind kind = MotionKind::newtonian;
  std::optional<double> time_step;   ///< [s]; none: chosen from the stiffest contact
  double duration = 0;               ///< [s]; of all stages together, where there are any
  std::optional<double> rest_speed;  ///< root-mean-square speed of a bed at rest, which ends the run [m/s]
  double rest_time = 0.01;           ///< for which it stays below [s]
  ContactVelocity contact_velocity = ContactVelocity::automatic;
  Precision precision = Precision::double_precision;
  std::optional<double>
      list_margin;  ///< that a particle may move before its neighbours are sought anew, over its radius

  // The quick way to rest; there where goal is rest. The defaults are measured, docs/rest.md.
  static constexpr double default_way_overlap = 2e-3, default_way_energy = 5e-3, default_unbalanced_force = 0.02;
  static constexpr double default_way_force = 0.05;  ///< rest_force of an overdamped way
  Goal goal = Goal::motion;
  std::optional<double> way_overlap;       ///< that softening may lead to under the bed's weight, over the radius
  std::optional<double> way_energy;        ///< kinetic, over the sum of m g d, with which the softened way ends
  std::optional<double> unbalanced_force;  ///< of the bed at rest, mean net force over mean contact force

  // Overdamped.
  ResistanceSpec resistance;  ///< of groups without one of their own
  Integrator integrator = Integrator::automatic;
  std::optional<double> tolerance;   ///< error of a step, root mean square over the mean radius
  std::optional<double> rest_force;  ///< unbalanced force of a bed at rest, which ends the run, or the way to rest

  bool overdamped() const { return kind == MotionKind::overdamped; }
};

struct DomainSpec {
  std::optional<Vec3> min;              ///< [m]
  std::optional<Vec3> max;              ///< [m]
  std::optional<double> volume_factor;  ///< domain volume over solid volume, instead of min and max
  std::optional<Vec3> aspect;           ///< sides' ratio that goes with volume_factor
  std::vector<int> periodic;            ///< axes, 0 to 2
  std::vector<int> open;                ///< Face values
};

struct GravitySpec {
  bool present = false;
  Vec3 acceleration = Vec3(0, 0, -9.8);  ///< [m/s2]
  double start = 0;                      ///< [s]
  std::optional<double> end;             ///< [s]
  std::vector<std::string> formula;      ///< three formulas in t instead of the acceleration; empty: none
};

/// A part of the run, which boundaries and their motions may refer to.
struct StageSpec {
  std::string name;
  double duration = 0;               ///< at most [s]
  std::optional<double> rest_speed;  ///< as in DynamicsSpec; ends the stage
  double rest_time = 0.01;           ///< [s]
  std::optional<double> rest_force;  ///< as in DynamicsSpec; ends the stage
};

/// Attraction between surfaces, in contact and across a gap.
struct VanDerWaalsSpec {
  bool present = false;
  double hamaker = 0;            ///< Hamaker constant [J]
  double min_gap = 1e-9;         ///< at which the attraction stops growing [m]
  std::optional<double> cutoff;  ///< gap beyond which it is left out [m]; 100 min_gap unless given
  double range() const { return present ? *cutoff : 0; }
};

struct ContactSpec {
  NormalModel normal = NormalModel::linear;
  TangentialModel tangential = TangentialModel::none;
  Release release = Release::zero_overlap;
  double sign_speed = 0;  ///< of the hysteretic law's regularised sign [m/s]; 0: it jumps
  VanDerWaalsSpec van_der_waals;
};

struct MaterialSpec {
  std::string name;
  double density = 0;  ///< [kg/m3]
  // Those that the scene's laws need are there once it has been read.
  std::optional<double> normal_stiffness;     ///< [N/m]
  std::optional<double> unloading_stiffness;  ///< walton-braun [N/m]
  std::optional<double> young_modulus;        ///< [Pa]
  std::optional<double> poisson_ratio;
  std::optional<double> normal_damping;        ///< hysteretic: pure number; linear and hertz: [N s/m]
  std::optional<double> restitution;           ///< instead of normal_damping
  std::optional<double> dissipation_time;      ///< B of kuwabara-kono [s]
  std::optional<double> shear_viscosity;       ///< eta_1, instead of dissipation_time with bulk_viscosity [Pa s]
  std::optional<double> bulk_viscosity;        ///< eta_2 [Pa s]
  std::optional<double> tangential_stiffness;  ///< [N/m]
  std::optional<double> tangential_damping;    ///< haff-werner [N s/m]
  double friction = 0;
};

struct GroupSpec {
  std::string name;  ///< shown in legends and tables; the material's name unless given
  std::string material;
  std::optional<std::int64_t> count;  ///< not given where a file holds the particles
  std::optional<double> radius;       ///< [m]; the same
  SizeSpec sizes;                     ///< instead of one radius
  ResistanceSpec resistance;          ///< to overdamped motion, instead of DynamicsSpec's
};

struct FillingSpec {
  FillingKind kind = FillingKind::growth;
  std::optional<double> duration;  ///< of the growth [s]
  Lattice lattice = Lattice::cubic;
  std::optional<double> spacing;    ///< of nearest sites of the lattice [m]; the largest diameter unless given
  std::optional<Vec3> region_min;   ///< to fill [m]; the domain unless given
  std::optional<Vec3> region_max;   ///< [m]
  std::optional<std::string> path;  ///< of the file, from the root

  // Pouring.
  std::optional<double> rate;            ///< [1/s]
  std::optional<std::int64_t> portions;  ///< each when the one before has come to rest
  std::optional<double> rest_speed;      ///< below which it has [m/s]
  std::optional<double> rest_force;      ///< likewise in overdamped motion
  Vec3 velocity = Vec3::Zero();          ///< with which particles come in [m/s]
  std::optional<double> most_mass;       ///< to pour [kg]
  std::optional<double> fill_height;     ///< of the bed, at which pouring ends [m]

  /// When all particles have their full size [s].
  double over() const { return duration.value_or(0); }
};

struct OutputSpec {
  double interval = 0;  ///< between snapshots [s]
  std::vector<int> fields;
  bool contacts = true;
  double history_interval = 1e-3;  ///< [s]
  static constexpr double default_checkpoint_interval = 600;
  std::optional<double> checkpoint_interval;  ///< of wall time between checkpoints [s]
};

struct MonitorSpec {
  double overlap_limit = 0.05;    ///< share of the smaller radius
  double energy_tolerance = 0.2;  ///< share of the energy put in so far
};

/// Output fields in the order of OutputSpec::fields' indices.
enum OutputField {
  output_velocity,
  output_angular_velocity,
  output_force,
  output_acceleration,
  output_angular_acceleration,
  output_mass,
  output_full_radius,
  output_moment_of_inertia,
  output_kinetic_translational,
  output_kinetic_rotational,
  output_elastic,
  output_gravitational
};

struct Scene {
  std::string title = "untitled";
  std::int64_t seed = 1;
  DynamicsSpec dynamics;
  DomainSpec domain;
  GravitySpec gravity;
  ContactSpec contact;
  std::vector<MaterialSpec> materials;
  std::vector<GroupSpec> particles;
  FillingSpec filling;
  std::vector<BoundarySpec> boundaries;
  std::vector<StageSpec> stages;
  OutputSpec output;
  MonitorSpec monitor;

  /// "FILE:LINE:COL" of every key that was read, by path ("material[0].density").
  std::map<std::string, std::string> locations;

  /// Throws InputError "FILE:LINE:COL: key: what", located at the key or the nearest table above it.
  [[noreturn]] void fail(const std::string& path, const std::string& what) const;

  /// Smallest and largest radius of a group that has any [m].
  SizeRange size_range(std::size_t group) const;
  /// Radii of all particles of a group, in the order of their ids [m].
  std::vector<double> radii(std::size_t group) const;
  /// Volume of all spheres that the groups ask for, at full size [m3]; 0 when a file holds them.
  double solid_volume() const;
  /// The box, from min and max or from the particles' volume.
  Domain box() const;
  /// Index into materials of a name that validation has found.
  int material_index(const std::string& name) const;
};

/// The one description of every key.
void describe(OptionVisitor& visitor, Scene& scene);

/// Reads, checks each key and the keys against each other.
/// Overrides are "key=value" texts such as "dynamics.time_step=10 us" or "particles[0].count=100".
/// A relative filling.path is seen from the scene file's folder; in an override or a scene given as text, from the
/// current folder.
/// Throws InputError "FILE:LINE:COL: key: what is wrong; what would be right".
Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
Scene parse_scene(const std::string& text, const std::string& source_name,
                  const std::vector<std::string>& overrides = {});

/// The scene as TOML with every default filled in; reading it back gives the same scene.
std::string to_toml(const Scene& scene);

/// 16 hex digits that change with any value of the scene (FNV-1a, 64 bits, of to_toml).
std::string scene_hash(const Scene& scene);

/// docs/scene.md, and the short list that `--help` shows.
std::string scene_reference_markdown();
std::string scene_reference_text();

}  // namespace packstone
