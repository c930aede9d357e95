// Maps of how particles come in, move on and meet walls.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/study/map_parts.hpp"

namespace packstone::cli {

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
    s.dynamics = step_in_contact_times(y);
    s.contact = "normal = \"linear\"";
    s.material = bead_material();
    s.particles = beads(150);
    s.domain = "volume_factor = 1.667\naspect = [1, 1, 1]\nperiodic = [\"x\", \"y\", \"z\"]";
    s.filling = fmt::format("kind = \"growth\"\nduration = {}", x * contact_time);
    s.gravity = s.floor = "";
    s.duration = 1.2 * x * contact_time;
    s.rows = std::max(2.0, std::min(50.0, std::floor(s.duration / (y * contact_time))));
    return s.text();
  };
  map.limits = {{"overlap of an impact at the radii's speed = monitor.overlap_limit",
                 [](double) { return 2 / (std::numbers::pi * bed_overlap_limit); }}};
  return map;
}

StabilityMap creep_map(const std::string& name, const std::string& law, const std::string& keys) {
  StabilityMap map;
  map.name = "creep_" + name;
  map.description = "Bed on a slope of 10 degrees, " + law + ": whether it creeps";
  map.y_label = "Friction";
  map.x = ratios(0.01, 0.3, 8);
  map.y = {0.05, 0.1, 0.176, 0.3, 0.5, 0.8};
  map.scene = [law, keys](double x, double y) {
    constexpr double slope = 10 * std::numbers::pi / 180;
    SceneText s;
    s.dynamics = step_in_contact_times(x);
    s.contact = fmt::format("normal = \"linear\"\ntangential = \"{}\"", law);
    s.material = bead_material() + fmt::format("friction = {}\n{}", y, keys);
    s.gravity = fmt::format("[gravity]\nacceleration = [{}, 0, {}]\n", earth_gravity * std::sin(slope),
                            -earth_gravity * std::cos(slope));
    s.particles = beads(40);
    s.domain = "min = [0, 0, 0]\nmax = [0.05, 0.042, 0.08]\nperiodic = [\"y\"]\nopen = [\"z+\"]";
    s.floor +=
        "[[boundary]]\nname = \"stop\"\nkind = \"plane\"\npoint = [0.05, 0, 0]\nnormal = [-1, 0, 0]\n"
        "[[boundary]]\nname = \"back\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]\n";
    s.duration = 2;
    return s.text();
  };
  map.trouble = [](const Outcome& o) {
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
    s.dynamics = step_in_contact_times(x);
    s.contact = "normal = \"linear\"";
    s.material = bead_material();
    const double side = std::max(0.042, 4.8 * y * bead_radius);
    const auto small = static_cast<int>(60 * std::pow(side / 0.042, 2));
    s.particles = beads_and(small, 2, y * bead_radius);
    s.overlap_limit = 0.5;  // of the small ones, on which large ones fall
    s.domain = fmt::format("min = [0, 0, 0]\nmax = [{0}, {0}, {1}]\nperiodic = [\"x\", \"y\"]\nopen = [\"z+\"]", side,
                           std::max(0.12, 8 * y * bead_radius));
    return s.text();
  };
  map.limits = {packing_line(), single_line()};
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
        fmt::format("kind = \"overdamped\"\nviscosity = {}\nintegrator = \"euler\"\ntime_step = {}", mu, x * mu / k);
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}", k);
    s.overlap_limit = 0.9;
    s.duration = 0.15 / (bead_mass * earth_gravity / mu);  // a free sphere sinks through the domain and more
    return s.text();
  };
  map.limits = {{"2/(2 k/mu) of one contact", [](double) { return 1.0; }},
                {"a fifth of it, for a bed's 6 contacts (docs/overdamped.md)", [](double) { return 0.2; }}};
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
    s.dynamics = fmt::format("time_step = {}", x * bead_radius / speed);
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.9", k);
    s.particles = beads(1);
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
  map.trouble = [](const Outcome& o) {
    if (o.last.position.empty() || o.last.position.front()[2] > 0) return std::string();
    return std::string("it went through the plate");
  };
  map.limits = {{"half a radius in a step, the monitor's", [](double) { return 0.5; }}};
  return map;
}

}  // namespace packstone::cli
