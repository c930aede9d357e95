#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/study/stability_map.hpp"
#include "core/error.hpp"
#include "core/geometry.hpp"
#include "engine/simulation.hpp"

namespace packstone::cli {

namespace {

double column(const std::vector<std::string>& columns, const std::vector<double>& row, const char* name) {
  return row[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin())];
}

/// Sum of m g d [J]; 0 without gravity.
double fall_energies(const Scene& scene) {
  if (!scene.gravity.present) return 0;
  double sum = 0;
  for (std::size_t g = 0; g < scene.particles.size(); ++g) {
    const double density = scene.materials[scene.material_index(scene.particles[g].material)].density;
    for (const double radius : scene.radii(g)) sum += density * sphere_volume(radius) * 2 * radius;
  }
  return sum * scene.gravity.acceleration.norm();
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::sound:
      return "sound";
    case Verdict::disturbed:
      return "disturbed";
    case Verdict::stopped:
      return "stopped";
    case Verdict::refused:
      break;
  }
  return "refused";
}

std::string energy_trouble(const Outcome& o) {
  constexpr double tolerable_energy_error = 0.02;  // of what was put in
  if (o.energy_error <= tolerable_energy_error) return "";
  return fmt::format("the energy account is off by {:.2g} of what was put in", o.energy_error);
}

Outcome outcome_of(const Scene& scene) {
  Outcome outcome;
  double largest_error = 0, input = 0;
  engine::SimulationEvents events;
  events.history = [&](const std::vector<std::string>& columns, const std::vector<double>& row) {
    const auto of = [&](const char* name) { return column(columns, row, name); };
    largest_error = std::max(largest_error, std::abs(of("energy_error")));
    input = std::max(input, std::abs(of("gravity_work")) + std::abs(of("growth_work")) + std::abs(of("wall_work")) +
                                of("kinetic_translational"));
    outcome.energy_error = input > 0 ? largest_error / input : 0;
    outcome.coordination = of("coordination");
    outcome.kinetic = of("kinetic_translational");
  };
  events.snapshot = [&](const Snapshot& s) { outcome.last = s; };
  try {
    engine::Simulation simulation(scene);
    simulation.run(events);
  } catch (const InputError& error) {
    outcome.verdict = Verdict::refused;
    outcome.reason = error.what();
  } catch (const RunError& error) {
    outcome.verdict = Verdict::stopped;
    outcome.reason = error.what();
  }
  const double falls = fall_energies(scene);
  outcome.kinetic = falls > 0 ? outcome.kinetic / falls : 0;
  return outcome;
}

MapPoint point_of(const StabilityMap& map, double x, double y) {
  MapPoint point{x, y, {}};
  try {
    point.outcome = outcome_of(parse_scene(map.scene(x, y), map.name));
  } catch (const InputError& error) {
    point.outcome.verdict = Verdict::refused;
    point.outcome.reason = error.what();
  }
  if (point.outcome.verdict != Verdict::sound) return point;
  point.outcome.reason = map.trouble(point.outcome);
  if (!point.outcome.reason.empty()) point.outcome.verdict = Verdict::disturbed;
  return point;
}

}  // namespace packstone::cli
