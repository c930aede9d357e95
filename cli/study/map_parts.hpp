// What the maps are made of: beads, the text of their scenes, judgements that several share. Each map is declared here
// and written beside those of its kind.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "cli/study/stability_map.hpp"
#include "core/geometry.hpp"

namespace packstone::cli {

// Glass-like beads, soft enough that a bed of them settles within a fraction of a second of computing.
inline constexpr double bead_radius = 5e-3, bead_density = 2500, bead_stiffness = 1e4, earth_gravity = 9.8;
inline const double bead_mass = bead_density * sphere_volume(bead_radius);
inline const double contact_time =
    std::numbers::pi * std::sqrt(0.5 * bead_mass / bead_stiffness);  ///< undamped, of two

inline constexpr double single_contact_limit = 2 / std::numbers::pi;  ///< of the contact time: 2/omega
/// 0.17 sqrt(m/k): O'Sullivan & Bray, Eng. Comput. 21 (2004) 278.
inline const double packing_limit = 0.17 * std::numbers::sqrt2 / std::numbers::pi;

inline constexpr double bed_overlap_limit = 0.15;  ///< of the radius: beads are soft, and fall

/// Of [[particles]]: so many beads, and further spheres of another radius [m].
std::string beads(int count);
std::string beads_and(int count, int further, double radius);

/// Of [[material]]: their stiffness, restitution 0.5.
std::string bead_material();

/// Tables of a scene in the order of a file.
struct SceneText {
  std::string dynamics, contact, material, filling = "kind = \"random\"";
  double duration = 0.4;
  std::string particles = beads(60);
  std::string domain = "min = [0, 0, 0]\nmax = [0.042, 0.042, 0.12]\nperiodic = [\"x\", \"y\"]\nopen = [\"z+\"]";
  std::string gravity = "[gravity]\nacceleration = [0, 0, -9.8]\n";
  double rows = 100;  ///< of history
  std::string floor = "[[boundary]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  double overlap_limit = bed_overlap_limit;

  std::string text() const;
};

/// time_step, so many contact times.
std::string step_in_contact_times(double share);

/// n values from low to high, equal ratios apart.
std::vector<double> ratios(double low, double high, int n);

/// What is wrong where a bed keeps more than 1e-3 of the sum of m g d as kinetic energy; empty if nothing is.
std::string rest_trouble(const Outcome& outcome);

Limit packing_line();
Limit single_line();

std::vector<StabilityMap> step_maps();
StabilityMap growth_map();
StabilityMap creep_map(const std::string& name, const std::string& law, const std::string& keys);
StabilityMap size_map();
StabilityMap overdamped_map();
StabilityMap wall_map();
StabilityMap jitter_map();
StabilityMap adhesion_map();
StabilityMap load_map();
StabilityMap precision_map();

}  // namespace packstone::cli
