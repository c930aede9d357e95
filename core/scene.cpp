#include "core/scene.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/geometry.hpp"
#include "core/hash.hpp"
#include "core/options_reader.hpp"
#include "core/text.hpp"

namespace packstone {

namespace {

using enum Presence;

/// Restitution exp(-2) of a critically damped linear contact that ends with its force.
constexpr double least_zero_force_restitution = 0.1353352832366127;

const ChoiceNames axes = {"x", "y", "z"};
const ChoiceNames faces = {"x-", "x+", "y-", "y+", "z-", "z+"};
const ChoiceNames output_fields = {"velocity", "angular_velocity", "force"};
const ChoiceNames dynamics_kinds = {"newtonian"};

void describe_dynamics(OptionVisitor& v, DynamicsSpec& d) {
  enum class Kind { newtonian } kind = Kind::newtonian;
  v.choice({"kind", "Equations of motion"}, dynamics_kinds, kind, has_default);
  v.number_or({"time_step", "Time step; \"auto\" takes the recommended share of the stiffest contact's duration",
               unit::second, Range::positive()},
              "auto", d.time_step);
  v.number({"duration", "Physical time to simulate, filling included", unit::second, Range::positive()}, d.duration,
           required);
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
}

void describe_contact(OptionVisitor& v, ContactSpec& c) {
  v.choice({"normal", "Normal contact law"}, {"linear", "hysteretic"}, c.normal, required);
  v.choice({"tangential", "Tangential contact law"}, {"none", "cundall-strack"}, c.tangential, has_default);
  v.choice({"release", "End of a linear contact: when the overlap is zero, or when the force would turn to a pull"},
           {"zero-overlap", "zero-force"}, c.release, has_default);
}

void describe_material(OptionVisitor& v, MaterialSpec& m) {
  v.text({"name", "Name that particles and boundaries refer to"}, m.name, required);
  v.number({"density", "Density", unit::density, Range::positive()}, m.density, required);
  v.number(
      {"normal_stiffness", "Spring constant k_n of a contact of two such bodies", unit::stiffness, Range::positive()},
      m.normal_stiffness, required);
  v.number(
      {"tangential_stiffness", "Spring constant k_s; needed by cundall-strack", unit::stiffness, Range::positive()},
      m.tangential_stiffness);
  v.number({"normal_damping", "Damping: hysteretic a pure number g below 1, linear a coefficient in N s/m",
            unit::damping, Range::at_least(0)},
           m.normal_damping);
  v.number(
      {"restitution", "Coefficient of restitution, instead of normal_damping", unit::none, Range::above_up_to(0, 1)},
      m.restitution);
  v.number({"friction", "Coulomb friction coefficient", unit::none, Range::at_least(0)}, m.friction, has_default);
}

void describe_group(OptionVisitor& v, GroupSpec& g) {
  v.text({"name", "Name in legends and tables; the material's unless given"}, g.name, has_default);
  v.text({"material", "Name of a [[material]]"}, g.material, required);
  v.integer({"count", "Number of particles; required unless filling.kind is file, and then not given", unit::none,
             Range::at_least(1)},
            g.count);
  v.number(
      {"radius", "Radius; required unless filling.kind is file, and then not given", unit::metre, Range::positive()},
      g.radius);
}

void describe_filling(OptionVisitor& v, FillingSpec& f) {
  v.choice({"kind",
            "How the particles come in. growth: centres at random, radii grow from zero to full size. file: as a file "
            "has them"},
           {"growth", "file"}, f.kind, required);
  v.number({"duration", "growth, required: time it takes", unit::second, Range::positive()}, f.duration);
  v.vector({"region_min", "growth: lower corner of the region to fill; the domain's unless given", unit::metre},
           f.region_min);
  v.vector({"region_max", "growth: upper corner of the region to fill", unit::metre}, f.region_max);
  v.text({"path",
          "file, required: a CSV table, a LAMMPS data file (atom_style sphere, units si) or a packstone snapshot, told "
          "apart by content; relative to the scene file's folder. docs/format.md has the columns"},
         f.path);
}

void describe_boundary(OptionVisitor& v, BoundarySpec& b) {
  v.text({"name", "Name in messages and tables"}, b.name, required);
  v.choice({"kind", "Shape"}, {"plane"}, b.kind, required);
  v.vector({"point", "A point of the plane", unit::metre}, b.point, required);
  v.vector({"normal", "Direction from the wall to the particles' side; any length"}, b.normal, required);
  v.text({"material", "Name of a [[material]]; the first one unless given"}, b.material, has_default);
}

void describe_output(OptionVisitor& v, OutputSpec& o) {
  v.number({"interval", "Time between snapshots", unit::second, Range::positive()}, o.interval, required);
  v.choices({"fields", "Particle quantities to write beside position, radius, id, type and material"}, output_fields,
            o.fields);
  v.boolean({"contacts", "Whether snapshots hold the contacts and their forces"}, o.contacts);
  v.number({"history_interval", "Time between rows of history.csv", unit::second, Range::positive()},
           o.history_interval, has_default);
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

void check_names(const Scene& s) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < s.materials.size(); ++k) {
    if (!names.insert(s.materials[k].name).second) {
      s.fail(fmt::format("material[{}].name", k),
             fmt::format("\"{}\" is taken; give each material its own name", s.materials[k].name));
    }
  }
  const std::vector<std::string> known(names.begin(), names.end());
  const auto check = [&](const std::string& path, const std::string& name) {
    if (names.count(name)) return;
    const auto near = nearest_name(name, known);
    s.fail(path, fmt::format("no material \"{}\"; {}", name,
                             near ? fmt::format("did you mean \"{}\"?", *near) : "there are: " + joined(known)));
  };
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    check(fmt::format("particles[{}].material", k), s.particles[k].material);
  }
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    check(fmt::format("boundary[{}].material", k), s.boundaries[k].material);
    if (s.boundaries[k].normal.norm() == 0) s.fail(fmt::format("boundary[{}].normal", k), "has no length");
  }
}

void check_damping_kinds(const Scene& s) {
  if (s.contact.normal != NormalModel::linear) return;
  for (std::size_t k = 1; k < s.materials.size(); ++k) {
    if (s.materials[k].restitution.has_value() == s.materials.front().restitution.has_value()) continue;
    s.fail(fmt::format("material[{}]", k),
           "with contact.normal = \"linear\" all materials give normal_damping, or all give restitution");
  }
}

void check_materials(const Scene& s) {
  for (std::size_t k = 0; k < s.materials.size(); ++k) {
    const MaterialSpec& m = s.materials[k];
    const std::string path = fmt::format("material[{}]", k);
    if (m.normal_damping && m.restitution) {
      s.fail(path + ".restitution", "is given beside normal_damping; keep one of the two");
    }
    if (!m.normal_damping && !m.restitution) s.fail(path, "needs normal_damping or restitution");
    if (s.contact.normal == NormalModel::linear && s.contact.release == Release::zero_force &&
        m.restitution.value_or(1) < least_zero_force_restitution) {
      s.fail(path + ".restitution", fmt::format("{:g} cannot be reached with contact.release = \"zero-force\", whose "
                                                "restitution is {:.3f} at critical damping; take \"zero-overlap\"",
                                                *m.restitution, least_zero_force_restitution));
    }
    if (s.contact.normal == NormalModel::hysteretic && m.normal_damping.value_or(0) >= 1) {
      s.fail(path + ".normal_damping",
             fmt::format("{:g} would pull on unloading; hysteretic damping is from 0 to below 1", *m.normal_damping));
    }
    if (s.contact.tangential == TangentialModel::cundall_strack && !m.tangential_stiffness) {
      s.fail(path, "needs tangential_stiffness for contact.tangential = \"cundall-strack\"");
    }
  }
}

/// A wall that leans towards a periodic side would stand elsewhere in every image.
void check_walls(const Scene& s) {
  const Domain box = s.box();
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!box.periodic[axis] || s.boundaries[k].normal[axis] == 0) continue;
      s.fail(fmt::format("boundary[{}].normal", k),
             fmt::format("has a component along {}, which is periodic; make the axis not periodic, or the component 0",
                         axes[axis]));
    }
  }
}

void refuse_given(const Scene& s, const std::string& path, bool given, const std::string& why) {
  if (given) s.fail(path, "is given beside filling.kind = " + why);
}

void check_growth_keys(const Scene& s) {
  if (!s.filling.duration) s.fail("filling", "needs duration, the time the growth takes [s], with kind = \"growth\"");
  refuse_given(s, "filling.path", s.filling.path.has_value(), "\"growth\"; take kind = \"file\", or leave it out");
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    const std::string path = fmt::format("particles[{}]", k);
    if (!s.particles[k].count) s.fail(path, "needs count, the number of particles");
    if (!s.particles[k].radius) s.fail(path, "needs radius [m]");
  }
}

void check_file_keys(const Scene& s) {
  const FillingSpec& f = s.filling;
  if (!f.path) s.fail("filling", "needs path, the file that holds the particles, with kind = \"file\"");
  const std::string nothing_grows = "\"file\", whose particles have their place and full size at once; leave it out";
  refuse_given(s, "filling.duration", f.duration.has_value(), nothing_grows);
  refuse_given(s, "filling.region_min", f.region_min.has_value(), nothing_grows);
  refuse_given(s, "filling.region_max", f.region_max.has_value(), nothing_grows);
  refuse_given(s, "domain.volume_factor", s.domain.volume_factor.has_value(),
               "\"file\", whose particles have their places in a box of their own; give min and max");
  for (std::size_t k = 0; k < s.particles.size(); ++k) {
    const std::string path = fmt::format("particles[{}]", k);
    const std::string file_has_it =
        "\"file\": the file says how many particles there are and of what radius; leave it out";
    refuse_given(s, path + ".count", s.particles[k].count.has_value(), file_has_it);
    refuse_given(s, path + ".radius", s.particles[k].radius.has_value(), file_has_it);
  }
}

void check_filling(const Scene& s) {
  s.filling.kind == FillingKind::growth ? check_growth_keys(s) : check_file_keys(s);
}

void check_domain(const Scene& s) {
  const DomainSpec& d = s.domain;
  if (d.volume_factor ? (d.min || d.max || !d.aspect) : (!d.min || !d.max || d.aspect)) {
    s.fail("domain", "needs either min and max, or volume_factor and aspect");
  }
  const Domain box = s.box();
  for (int k = 0; k < 3; ++k) {
    if (!(box.max[k] > box.min[k])) s.fail("domain.max", "must lie above domain.min along every axis");
  }
  for (int face : d.open) {
    if (box.periodic[face / 2]) s.fail("domain.open", fmt::format("\"{}\" is a periodic side", faces[face]));
  }
  const Vec3 low = s.filling.region_min.value_or(box.min), high = s.filling.region_max.value_or(box.max);
  if ((low.array() < box.min.array()).any()) s.fail("filling.region_min", "lies outside the domain");
  if ((high.array() > box.max.array()).any()) s.fail("filling.region_max", "lies outside the domain");
  if ((high.array() <= low.array()).any()) s.fail("filling.region_max", "must lie above filling.region_min");
}

void fill_defaults(Scene& s) {
  for (auto& group : s.particles) {
    if (group.name.empty()) group.name = group.material;
  }
  for (auto& boundary : s.boundaries) {
    if (boundary.material.empty()) boundary.material = s.materials.front().name;
  }
}

/// From the root, so that the run folder's copy of the scene finds the file too.
void complete_path(Scene& s, const std::filesystem::path& folder) {
  if (!s.filling.path) return;
  const bool overridden = s.locations.at("filling.path").starts_with("--set");
  const std::filesystem::path base = overridden ? std::filesystem::current_path() : folder;
  s.filling.path = (base / *s.filling.path).lexically_normal().string();
}

Scene parse_scene_in(const std::filesystem::path& folder, const std::string& text, const std::string& source_name,
                     const std::vector<std::string>& overrides) {
  Scene scene;
  OptionReader reader(text, source_name, overrides, scene.locations);
  describe(reader, scene);
  reader.finish();
  fill_defaults(scene);
  complete_path(scene, folder);
  check_names(scene);
  check_materials(scene);
  check_damping_kinds(scene);
  check_filling(scene);
  check_domain(scene);
  check_walls(scene);
  return scene;
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
  v.table({"output", "What the run folder holds"}, required, [&] { describe_output(v, s.output); });
  v.table({"monitor", "Limits at which a run that goes wrong is stopped"}, has_default,
          [&] { describe_monitor(v, s.monitor); });
}

void Scene::fail(const std::string& path, const std::string& what) const {
  std::string at = path;
  while (!at.empty() && !locations.count(at)) {
    const std::size_t cut = at.find_last_of(".[");
    at = cut == std::string::npos ? "" : at.substr(0, cut);
  }
  const auto found = locations.find(at);
  throw InputError((found == locations.end() ? "" : found->second + ": ") + path + ": " + what);
}

double Scene::solid_volume() const {
  double total = 0;
  for (const auto& g : particles)
    total += static_cast<double>(g.count.value_or(0)) * sphere_volume(g.radius.value_or(0));
  return total;
}

Domain Scene::box() const {
  Domain box;
  for (int axis : domain.periodic) box.periodic[axis] = true;
  if (domain.volume_factor) {
    box.min.setZero();
    box.max = *domain.aspect * std::cbrt(*domain.volume_factor * solid_volume() / domain.aspect->prod());
  } else {
    box.min = *domain.min;
    box.max = *domain.max;
  }
  return box;
}

int Scene::material_index(const std::string& name) const {
  const auto found = std::find_if(materials.begin(), materials.end(), [&](const auto& m) { return m.name == name; });
  return static_cast<int>(found - materials.begin());
}

Scene parse_scene(const std::string& text, const std::string& source_name, const std::vector<std::string>& overrides) {
  return parse_scene_in(std::filesystem::current_path(), text, source_name, overrides);
}

Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  return parse_scene_in(folder, read_text_file(path), path.string(), overrides);
}

std::string scene_hash(const Scene& scene) { return content_hash(to_toml(scene)); }

}  // namespace packstone
