// Maps of single contacts: at rest, attracted, pressed, rounded.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/study/map_parts.hpp"

namespace packstone::cli {

StabilityMap jitter_map() {
  StabilityMap map;
  map.name = "jitter";
  map.description = "Hysteretic contact at rest: time step against sign speed";
  map.y_label = "contact.sign_speed [m/s]";
  map.log_y = true;
  map.x = ratios(0.005, 0.3, 9);
  map.y = ratios(1e-6, 1e-1, 8);
  static constexpr double g = 0.7;
  map.scene = [](double x, double y) {
    SceneText s;
    s.dynamics = step_in_contact_times(x);
    s.contact = fmt::format("normal = \"hysteretic\"\nsign_speed = {}", y);
    s.material = fmt::format("normal_stiffness = {}\nnormal_damping = {}", bead_stiffness, g);
    s.particles = beads(1);
    s.filling = "kind = \"lattice\"\nspacing = 0.0101";
    s.duration = 1;
    return s.text();
  };
  map.trouble = [](const Outcome& o) {
    constexpr double at_rest = 1e-13;  // of m g d
    return o.kinetic <= at_rest
               ? ""
               : fmt::format("a sphere on the floor keeps {:.2g} of m g d as kinetic energy", o.kinetic);
  };
  // docs/physics.md: a sphere rests where dt < m w/(g k xi), k xi its weight.
  map.limits = {{"m w/(g k xi)", [](double w) { return w / (g * earth_gravity) / contact_time; }}};
  return map;
}

StabilityMap adhesion_map() {
  StabilityMap map;
  map.name = "adhesion";
  map.description = "Van der Waals attraction: the smallest gap against the time step";
  map.y_label = "Smallest gap over radius";
  map.log_y = true;
  map.x = ratios(0.002, 0.5, 9);
  map.y = ratios(1e-6, 1e-3, 7);
  // A Hamaker constant that gives a pull of ten weights in contact, whatever the gap.
  static const auto hamaker = [](double gap) { return 10 * bead_mass * earth_gravity * 12 * gap * gap / bead_radius; };
  map.scene = [](double x, double y) {
    SceneText s;
    const double gap = y * bead_radius;
    s.dynamics = step_in_contact_times(x);
    s.contact =
        fmt::format("normal = \"linear\"\n[contact.van_der_waals]\nhamaker = {}\nmin_gap = {}", hamaker(gap), gap);
    s.material = bead_material();
    s.duration = 0.2;
    return s.text();
  };
  // The force's slope over the gap is A R_eff/(3 h^3), 2 F/h.
  map.limits = {{"2 sqrt(m_eff/slope) of the attraction at the smallest gap",
                 [](double y) {
                   const double slope = 2 * 10 * bead_mass * earth_gravity / (y * bead_radius);
                   return 2 * std::sqrt(0.5 * bead_mass / slope) / contact_time;
                 }},
                packing_line()};
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
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.5", k);
    s.particles = beads(static_cast<int>(y));
    s.domain = fmt::format("min = [0, 0, 0]\nmax = [0.011, 0.011, {}]", 0.0101 * y + 0.001);
    s.filling = "kind = \"lattice\"\nspacing = 0.010001";
    const double slowest = 4 * y * std::sqrt(bead_mass / k);  // periods of the column's swing
    s.duration = 20 * slowest;
    return s.text();
  };
  map.limits = {{"weight above = k R monitor.overlap_limit", [](double n) { return n / bed_overlap_limit; }},
                {"twice that: a load put on at once", [](double n) { return 2 * n / bed_overlap_limit; }}};
  return map;
}

StabilityMap precision_map() {
  StabilityMap map;
  map.name = "precision";
  map.description = "Single precision: stiffness against the ratio of radii";
  map.x_label = "k R over a sphere's weight";
  map.y_label = "Ratio of radii";
  map.x = ratios(1e3, 1e7, 9);
  map.y = {1, 1.5, 2};
  map.scene = [](double x, double y) {
    const double k = x * bead_mass * earth_gravity / bead_radius;
    SceneText s;
    s.dynamics = "precision = \"mixed\"\ntime_step = \"auto\"";
    s.contact = "normal = \"linear\"";
    s.material = fmt::format("normal_stiffness = {}\nrestitution = 0.1", k);
    s.particles = beads_and(1, 1, y * bead_radius);
    s.domain = fmt::format("min = [0, 0, 0]\nmax = [{0}, {0}, {1}]\nopen = [\"z+\"]", 2.02 * y * bead_radius,
                           5 * y * bead_radius);
    s.filling = fmt::format("kind = \"lattice\"\nspacing = {}", 2.001 * y * bead_radius);
    s.duration = 0.6;
    return s.text();
  };
  map.trouble = rest_trouble;
  // engine/force_resolution.hpp: 7e-8 of the mean radius.
  map.limits = {{"rounding = a hundredth of the weight", [](double y) { return 0.01 / (7e-8 * 0.5 * (1 + y)); }}};
  return map;
}

}  // namespace packstone::cli
