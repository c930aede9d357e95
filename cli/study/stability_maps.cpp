// What each map sweeps, what theory says of it, and how a run that came to its end is judged.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cli/study/stability_map.hpp"
#include "core/geometry.hpp"

namespace packstone::cli {

namespace {

// Glass-like beads, soft enough that a bed of them settles within a fraction of a second of computing.
constexpr double bead_radius = 5e-3, bead_density = 2500, bead_stiffness = 1e4, earth_gravity = 9.8;
const double bead_mass = bead_density * sphere_volume(bead_radius);
const double contact_time = std::numbers::pi * std::sqrt(0.5 * bead_mass / bead_stiffness);  ///< undamped, of two

constexpr double single_contact_limit = 2 / std::numbers::pi;  ///< of the contact time: 2/omega
/// 0.17 sqrt(m/k): O'Sullivan & Bray, Eng. Comput. 21 (2004) 278.
const double packing_limit = 0.17 * std::numbers::sqrt2 / std::numbers::pi;

constexpr double bed_overlap_limit = 0.15;
constexpr double tolerable_energy_error = 0.02;  ///< of what was put in
constexpr double tolerable_kinetic = 1e-3;       ///< of the sum of m g d, of a bed that should be at rest

/// Tables of a scene in the order of a file.
struct SceneText {
  std::string dynamics, contact, material, filling = "kind = \"random\"";
  double duration = 0.4;
  std::string particles = "count = 60\nradius = 0.005";
  std::string domain = "min = [0, 0, 0]\nmax = [0.042, 0.042, 0.12]\nperiodic = [\"x\", \"y\"]\nopen = [\"z+\"]";
  std::string gravity = "[gravity]\nacceleration = [0, 0, -9.8]\n";
  double rows = 100;  ///< of history
  std::string floor = "[[boundary]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  double overlap_limit = bed_overlap_limit;

  std::string text() const {
    return fmt::format(
        "[dynamics]\nduration = {}\n{}\n[domain]\n{}\n{}[contact]\n{}\n[[material]]\nname = \"m\"\ndensity = 2500\n{}\n"
        "[[particles]]\nmaterial = \"m\"\n{}\n[filling]\n{}\n{}[output]\ninterval = {}\nhistory_interval = {}\n"
        "contacts = false\nfields = [\"velocity\"]\n[monitor]\noverlap_limit = {}\n",
        duration, dynamics, domain, gravity, contact, material, particles, filling, floor, duration / 4,
        duration / rows, overlap_limit);
  }
};

std::string step_key(double step) { return fmt::format("time_step = {}", step); }

/// n values from low to high, equal ratios apart.
std::vector<double> ratios(double low, double high, int n) {
  std::vector<double> values;
  for (int k = 0; k < n; ++k) values.push_back(low * std::pow(high / low, static_cast<double>(k) / (n - 1)));
  return values;
}

std::vector<double> evenly(double low, double high, int n) {
  std::vector<double> values;
  for (int k = 0; k < n; ++k) values.push_back(low + (high - low) * k / (n - 1));
  return values;
}

std::string energy_trouble(const Outcome& o) {
  if (o.energy_error <= tolerable_energy_error) return "";
  return fmt::format("the energy account is off by {:.2g} of what was put in", o.energy_error);
}

std::string rest_trouble(const Outcome& o) {
  if (o.kinetic <= tolerable_kinetic) return "";
  return fmt::format("kinetic energy stays at {:.2g} of the sum of m g d", o.kinetic);
}

Limit packing_line() {
  return {"0.17 sqrt(m/k), O'Sullivan & Bray", [](double) { return packing_limit; }};
}
Limit single_line() {
  return {"2/omega of one contact", [](double) { return single_contact_limit; }};
}

/// A law in a bed that settles, over the step and its damping.
struct LawMap {
  const char* name;
  const char* law;
  const char* y_label;
  std::vector<double> y;
  std::function<std::string(double y)> material;
};

StabilityMap step_map(const LawMap& law) {
  StabilityMap map;
  map.name = std::string("step_") + law.name;
  map.description = fmt::format("Settling bed, {} contacts: time step against damping", law.law);
  map.x_label = "Time step over contact time";
  map.y_label = law.y_label;
  map.x = {0.02, 0.04, 0.0765, 0.11, 0.15, 0.2, 0.27, 0.36, 0.48, 0.6, 0.75};
  map.y = law.y;
  map.scene = [law](double x, double y) {
    SceneText s;
    s.dynamics = step_key(x * contact_time);
    s.contact = fmt::format("normal = \"{}\"", law.law);
    s.material = law.material(y);
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) { return energy_trouble(o); };
  map.limits = {packing_line(), single_line()};
  return map;
}

std::vector<StabilityMap> step_maps() {
  const std::string springs = fmt::format("normal_stiffness = {}\n", bead_stiffness);
  // As stiff as the springs at the overlap limit, where steps are reckoned.
  const double at = bed_overlap_limit * bead_radius;
  const double modulus = bead_stiffness / (1.5 * 4.0 / 3 * std::sqrt(0.5 * bead_radius * at) / (2 * 0.91));
  const std::string elastic = fmt::format("young_modulus = {}\npoisson_ratio = 0.3\n", modulus);
  const std::vector<double> restitutions = {0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95};
  const auto restitution = [](const std::string& with) {
    return [with](double e) { return with + fmt::format("restitution = {}", e); };
  };
  std::vector<StabilityMap> maps;
  maps.push_back(step_map({"linear", "linear", "Restitution", restitutions, restitution(springs)}));
  // Estimated velocity, docs/physics.md: w^2 dt^2 + 4 G dt < 4, G = zeta w.
  maps.back().limits.push_back({"w^2 dt^2 + 4 zeta w dt = 4, one damped contact", [](double e) {
                                  const double l = std::log(e);
                                  const double zeta = -l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l);
                                  return (std::sqrt(zeta * zeta + 1) - zeta) * single_contact_limit;
                                }});
  maps.push_back(step_map({"hertz", "hertz", "Restitution", restitutions, restitution(elastic)}));
  maps.push_back(
      step_map({"kuwabara_kono", "kuwabara-kono", "Dissipation time over contact time", ratios(0.01, 1, 7),
                [elastic](double b) { return elastic + fmt::format("dissipation_time = {}", b * contact_time); }}));
  maps.back().log_y = true;
  maps.push_back(step_map(
      {"walton_braun", "walton-braun", "k_1/k_2", {0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 1}, [springs](double share) {
         return springs + fmt::format("unloading_stiffness = {}", bead_stiffness / share);
       }}));
  maps.push_back(
      step_map({"hysteretic", "hysteretic", "Damping g", {0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95}, [springs](double g) {
                  return springs + fmt::format("normal_damping = {}", g);
                }}));
  maps.back().trouble = [](const Outcome& o, double, double) {
    const std::string energy = energy_trouble(o);
    return energy.empty() ? rest_trouble(o) : energy;
  };
  return maps;
}

StabilityMap growth_map() {
  StabilityMap map;
  map.name = "growth";
  map.description = "Growth filling to a fraction of 0.6: how fast radii may grow";
  map.x_label = "Duration of the growth over contact time";
  map.y_label = "Time step over contact time";
  map.x = ratios(3, 1000, 10);
  map.y = ratios(0.02, 0.4, 7);
  map.log_y = true;
  map.scene = [](double x, double y) {
    SceneText s;
    s.dynamics = step_key(y * contact_time);
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.5", bead_stiffness);
    s.particles = "count = 150\nradius = 0.005";
    s.domain = "volume_factor = 1.667\naspect = [1, 1, 1]\nperiodic = [\"x\", \"y\", \"z\"]";
    s.filling = fmt::format("kind = \"growth\"\nduration = {}", x * contact_time);
    s.gravity = s.floor = "";
    s.duration = 1.2 * x * contact_time;
    s.rows = std::max(2.0, std::min(50.0, std::floor(s.duration / (y * contact_time))));
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) { return energy_trouble(o); };
  map.limits = {{"overlap of an impact at the radii's speed = monitor.overlap_limit",
                 [](double) { return 2 / (std::numbers::pi * bed_overlap_limit); }}};
  return map;
}

StabilityMap jitter_map() {
  StabilityMap map;
  map.name = "jitter";
  map.description = "Hysteretic contact at rest: time step against sign speed";
  map.x_label = "Time step over contact time";
  map.y_label = "contact.sign_speed [m/s]";
  map.log_y = true;
  map.x = ratios(0.005, 0.3, 9);
  map.y = ratios(1e-6, 1e-1, 8);
  static constexpr double g = 0.7;
  map.scene = [](double x, double y) {
    SceneText s;
    s.dynamics = step_key(x * contact_time);
    s.contact = fmt::format("normal = \"hysteretic\"\nsign_speed = {}", y);
    s.material = fmt::format("normal_stiffness = {}\nnormal_damping = {}", bead_stiffness, g);
    s.particles = "count = 1\nradius = 0.005";
    s.filling = "kind = \"lattice\"\nspacing = 0.0101";
    s.duration = 1;
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) {
    constexpr double at_rest = 1e-13;  // of m g d
    return o.kinetic <= at_rest
               ? ""
               : fmt::format("a sphere on the floor keeps {:.2g} of m g d as kinetic energy", o.kinetic);
  };
  // docs/physics.md: a sphere rests where dt < m w/(g k xi), k xi its weight.
  map.limits = {{"m w/(g k xi)", [](double w) { return w / (g * earth_gravity) / contact_time; }}};
  return map;
}

StabilityMap creep_map(const std::string& name, const std::string& law, const std::string& keys) {
  StabilityMap map;
  map.name = "creep_" + name;
  map.description = "Bed on a slope of 10 degrees, " + law + ": whether it creeps";
  map.x_label = "Time step over contact time";
  map.y_label = "Friction";
  map.x = ratios(0.01, 0.3, 8);
  map.y = {0.05, 0.1, 0.176, 0.3, 0.5, 0.8};
  map.scene = [law, keys](double x, double y) {
    constexpr double slope = 10 * std::numbers::pi / 180;
    SceneText s;
    s.dynamics = step_key(x * contact_time);
    s.contact = fmt::format("normal = \"linear\"\ntangential = \"{}\"", law);
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.5\nfriction = {}\n{}", bead_stiffness, y, keys);
    s.gravity = fmt::format("[gravity]\nacceleration = [{}, 0, {}]\n", earth_gravity * std::sin(slope),
                            -earth_gravity * std::cos(slope));
    s.particles = "count = 40\nradius = 0.005";
    s.domain = "min = [0, 0, 0]\nmax = [0.05, 0.042, 0.08]\nperiodic = [\"y\"]\nopen = [\"z+\"]";
    s.floor +=
        "[[boundary]]\nname = \"stop\"\nkind = \"plane\"\npoint = [0.05, 0, 0]\nnormal = [-1, 0, 0]\n"
        "[[boundary]]\nname = \"back\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]\n";
    s.duration = 2;
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) {
    constexpr double still = 1e-5;  // m/s, root mean square
    double sum = 0;
    const auto velocity = o.last.fields.find("velocity");
    for (const double v : velocity->second.values) sum += v * v;
    const double speed = std::sqrt(sum / static_cast<double>(o.last.position.size()));
    return speed <= still ? "" : fmt::format("after 2 s spheres still move at {:.2g} m/s, root mean square", speed);
  };
  map.limits = {packing_line()};
  return map;
}

StabilityMap adhesion_map() {
  StabilityMap map;
  map.name = "adhesion";
  map.description = "Van der Waals attraction: the smallest gap against the time step";
  map.x_label = "Time step over contact time";
  map.y_label = "Smallest gap over radius";
  map.log_y = true;
  map.x = ratios(0.002, 0.5, 9);
  map.y = ratios(1e-6, 1e-3, 7);
  // A Hamaker constant that gives a pull of ten weights in contact, whatever the gap.
  static const auto hamaker = [](double gap) { return 10 * bead_mass * earth_gravity * 12 * gap * gap / bead_radius; };
  map.scene = [](double x, double y) {
    SceneText s;
    const double gap = y * bead_radius;
    s.dynamics = step_key(x * contact_time);
    s.contact =
        fmt::format("normal = \"linear\"\n[contact.van_der_waals]\nhamaker = {}\nmin_gap = {}", hamaker(gap), gap);
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.5", bead_stiffness);
    s.duration = 0.2;
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) { return energy_trouble(o); };
  // The force's slope over the gap is A R_eff/(3 h^3), 2 F/h.
  map.limits = {{"2 sqrt(m_eff/slope) of the attraction at the smallest gap",
                 [](double y) {
                   const double slope = 2 * 10 * bead_mass * earth_gravity / (y * bead_radius);
                   return 2 * std::sqrt(0.5 * bead_mass / slope) / contact_time;
                 }},
                packing_line()};
  return map;
}

StabilityMap size_map() {
  StabilityMap map;
  map.name = "size_ratio";
  map.description = "Two large spheres in a bed of small ones: time step against ratio";
  map.x_label = "Time step over contact time of the small spheres";
  map.y_label = "Ratio of radii";
  map.x = {0.02, 0.04, 0.0765, 0.11, 0.15, 0.2, 0.27, 0.36, 0.48, 0.6};
  map.y = {1, 1.5, 2, 3, 4, 6};
  map.scene = [](double x, double y) {
    SceneText s;
    s.dynamics = step_key(x * contact_time);
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.5", bead_stiffness);
    const double side = std::max(0.042, 4.8 * y * bead_radius);
    const auto small = static_cast<int>(60 * std::pow(side / 0.042, 2));
    s.particles = fmt::format("count = {}\nradius = 0.005\n[[particles]]\nmaterial = \"m\"\ncount = 2\nradius = {}",
                              small, y * bead_radius);
    s.domain = fmt::format("min = [0, 0, 0]\nmax = [{0}, {0}, {1}]\nperiodic = [\"x\", \"y\"]\nopen = [\"z+\"]", side,
                           std::max(0.12, 8 * y * bead_radius));
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) { return energy_trouble(o); };
  map.limits = {packing_line(), single_line()};
  return map;
}

StabilityMap load_map() {
  StabilityMap map;
  map.name = "load";
  map.description = "A column's weight on its lowest sphere";
  map.x_label = "k R over a sphere's weight";
  map.y_label = "Spheres in the column";
  map.log_y = true;
  map.x = ratios(30, 1e5, 9);
  map.y = {1, 2, 4, 8, 16, 32};
  map.scene = [](double x, double y) {
    const double k = x * bead_mass * earth_gravity / bead_radius;
    SceneText s;
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.1", k);
    s.particles = fmt::format("count = {}\nradius = 0.005", static_cast<int>(y));
    s.domain = fmt::format("min = [0, 0, 0]\nmax = [0.011, 0.011, {}]", 0.0101 * y + 0.001);
    s.filling = "kind = \"lattice\"\nspacing = 0.010001";
    const double slowest = 4 * y * std::sqrt(bead_mass / k);  // periods of the column's swing
    s.duration = 20 * slowest;
    return s.text();
  };
  map.trouble = [](const Outcome&, double, double) { return std::string(); };
  map.limits = {{"weight above = k R monitor.overlap_limit", [](double n) { return n / bed_overlap_limit; }},
                {"twice that: a load put on at once", [](double n) { return 2 * n / bed_overlap_limit; }}};
  return map;
}

StabilityMap overdamped_map() {
  StabilityMap map;
  map.name = "overdamped";
  map.description = "Overdamped motion, explicit Euler: time step against stiffness";
  map.x_label = "Time step over mu/k";
  map.y_label = "chi, k R over a sphere's weight";
  map.log_y = true;
  map.x = ratios(0.05, 1.5, 9);
  map.y = ratios(30, 1000, 5);
  map.scene = [](double x, double y) {
    const double k = y * bead_mass * earth_gravity / bead_radius, mu = 1;
    SceneText s;
    s.dynamics =
        fmt::format("kind = \"overdamped\"\nviscosity = {}\nintegrator = \"euler\"\n{}", mu, step_key(x * mu / k));
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}", k);
    s.overlap_limit = 0.9;
    s.duration = 0.15 / (bead_mass * earth_gravity / mu);  // a free sphere sinks through the domain and more
    return s.text();
  };
  map.trouble = [](const Outcome&, double, double) { return std::string(); };
  map.limits = {{"2/(2 k/mu) of one contact", [](double) { return 1.0; }},
                {"a fifth of it, for a bed's 6 contacts (docs/overdamped.md)", [](double) { return 0.2; }}};
  return map;
}

StabilityMap precision_map() {
  StabilityMap map;
  map.name = "precision";
  map.description = "Single precision: stiffness against the ratio of radii";
  map.x_label = "k R over a sphere's weight";
  map.y_label = "Ratio of radii";
  map.x = ratios(1e3, 1e7, 9);
  map.y = {1, 2, 4};
  map.scene = [](double x, double y) {
    const double k = x * bead_mass * earth_gravity / bead_radius;
    SceneText s;
    s.dynamics = "precision = \"mixed\"\ntime_step = \"auto\"";
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.1", k);
    s.particles = fmt::format("count = 1\nradius = 0.005\n[[particles]]\nmaterial = \"m\"\ncount = 1\nradius = {}",
                              y * bead_radius);
    s.domain = fmt::format("min = [0, 0, 0]\nmax = [{0}, {0}, {1}]\nopen = [\"z+\"]", 2.02 * y * bead_radius,
                           5 * y * bead_radius);
    s.filling = fmt::format("kind = \"lattice\"\nspacing = {}", 2.001 * y * bead_radius);
    s.duration = 0.6;
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) { return rest_trouble(o); };
  // engine/force_resolution.hpp: 7e-8 of the mean radius.
  map.limits = {{"rounding = a hundredth of the weight", [](double y) { return 0.01 / (7e-8 * 0.5 * (1 + y)); }}};
  return map;
}

StabilityMap wall_map() {
  StabilityMap map;
  map.name = "wall_speed";
  map.description = "A sphere thrown at a thin plate: speed against stiffness";
  map.x_label = "Speed times time step over radius";
  map.y_label = "Impact overlap over radius";
  map.log_y = true;
  map.x = ratios(0.01, 4, 10);
  map.y = ratios(0.02, 1, 7);
  map.scene = [](double x, double y) {
    constexpr double speed = 10;
    // Overlap of an undamped impact: v sqrt(m/k).
    const double k = bead_mass * std::pow(speed / (y * bead_radius), 2);
    SceneText s;
    s.dynamics = step_key(x * bead_radius / speed);
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.9", k);
    s.particles = "count = 1\nradius = 0.005";
    s.gravity = "";
    s.filling =
        "kind = \"pour\"\nrate = 1e6\nregion_min = [0.01, 0.01, 0.1]\nregion_max = [0.032, 0.032, 0.118]\nvelocity = "
        "[0, 0, -10]";
    s.domain = "min = [0, 0, -0.2]\nmax = [0.042, 0.042, 0.2]\nopen = [\"z+\", \"z-\"]";
    s.floor =
        "[[boundary]]\nname = \"plate\"\nkind = \"polygons\"\nside = \"both\"\npolygons = [[[0, 0, 0], [0.042, 0, 0], "
        "[0.042, 0.042, 0], [0, 0.042, 0]]]\n";
    s.duration = 0.02;
    s.rows = 4;
    return s.text();
  };
  map.trouble = [](const Outcome& o, double, double) {
    if (o.last.position.empty() || o.last.position.front()[2] > 0) return std::string();
    return std::string("it went through the plate");
  };
  map.limits = {{"half a radius in a step, the monitor's", [](double) { return 0.5; }}};
  return map;
}

}  // namespace

std::vector<StabilityMap> stability_maps(bool quick) {
  std::vector<StabilityMap> maps = step_maps();
  const std::string spring = fmt::format("tangential_stiffness = {}", bead_stiffness);
  for (const StabilityMap& map :
       {growth_map(), jitter_map(), creep_map("cundall_strack", "cundall-strack", spring),
        creep_map("coulomb", "coulomb", ""), creep_map("haff_werner", "haff-werner", "tangential_damping = 1"),
        adhesion_map(), size_map(), load_map(), overdamped_map(), precision_map(), wall_map()}) {
    maps.push_back(map);
  }
  if (!quick) return maps;
  for (StabilityMap& map : maps) {
    for (auto* values : {&map.x, &map.y}) {
      std::vector<double> coarse;
      for (std::size_t k = 0; k < values->size(); k += 2) coarse.push_back((*values)[k]);
      *values = coarse;
    }
  }
  return maps;
}

}  // namespace packstone::cli
