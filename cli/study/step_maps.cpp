// Time step against damping, one map a normal law.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/study/map_parts.hpp"

namespace packstone::cli {

namespace {

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
  map.y_label = law.y_label;
  map.x = {0.02, 0.04, 0.0765, 0.11, 0.15, 0.2, 0.27, 0.36, 0.48, 0.6, 0.75};
  map.y = law.y;
  map.scene = [law](double x, double y) {
    SceneText s;
    s.dynamics = step_in_contact_times(x);
    s.contact = fmt::format("normal = \"{}\"", law.law);
    s.material = law.material(y);
    return s.text();
  };
  map.limits = {packing_line(), single_line()};
  return map;
}

}  // namespace

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
  maps.back().trouble = [](const Outcome& o) {
    const std::string energy = energy_trouble(o);
    return energy.empty() ? rest_trouble(o) : energy;
  };
  return maps;
}

}  // namespace packstone::cli
