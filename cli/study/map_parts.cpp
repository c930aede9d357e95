#include "cli/study/map_parts.hpp"

#include <cmath>

#include <fmt/format.h>

namespace packstone::cli {

std::string SceneText::text() const {
  return fmt::format(
      "[dynamics]\nduration = {}\n{}\n[domain]\n{}\n{}[contact]\n{}\n[[material]]\nname = \"m\"\ndensity = {}\n{}\n"
      "[[particles]]\nmaterial = \"m\"\n{}\n[filling]\n{}\n{}[output]\ninterval = {}\nhistory_interval = {}\n"
      "contacts = false\nfields = [\"velocity\"]\n[monitor]\noverlap_limit = {}\n",
      duration, dynamics, domain, gravity, contact, bead_density, material, particles, filling, floor, duration / 4,
      duration / rows, overlap_limit);
}

std::string beads(int count) { return fmt::format("count = {}\nradius = {}", count, bead_radius); }

std::string beads_and(int count, int further, double radius) {
  return beads(count) + fmt::format("\n[[particles]]\nmaterial = \"m\"\ncount = {}\nradius = {}", further, radius);
}

std::string bead_material() { return fmt::format("normal_stiffness = {}\nrestitution = 0.5\n", bead_stiffness); }

std::string step_in_contact_times(double share) { return fmt::format("time_step = {}", share * contact_time); }

std::vector<double> ratios(double low, double high, int n) {
  std::vector<double> values;
  for (int k = 0; k < n; ++k) values.push_back(low * std::pow(high / low, static_cast<double>(k) / (n - 1)));
  return values;
}

std::string rest_trouble(const Outcome& o) {
  constexpr double tolerable_kinetic = 1e-3;  // of the sum of m g d
  if (o.kinetic <= tolerable_kinetic) return "";
  return fmt::format("kinetic energy stays at {:.2g} of the sum of m g d", o.kinetic);
}

Limit packing_line() {
  return {"0.17 sqrt(m/k), O'Sullivan & Bray", [](double) { return packing_limit; }};
}
Limit single_line() {
  return {"2/omega of one contact", [](double) { return single_contact_limit; }};
}

}  // namespace packstone::cli
