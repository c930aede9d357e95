#include "engine/history_row.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace packstone::engine {

std::vector<std::string> history_columns(const Scene& scene) {
  std::vector<std::string> columns = {"step",
                                      "time",
                                      "kinetic_translational",
                                      "kinetic_rotational",
                                      "elastic",
                                      "attractive",
                                      "gravitational",
                                      "dissipated",
                                      "dissipated_normal",
                                      "dissipated_tangential",
                                      "growth_work",
                                      "gravity_work",
                                      "wall_work",
                                      "energy_error",
                                      "contacts",
                                      "wall_contacts",
                                      "coordination",
                                      "max_overlap",
                                      "max_speed",
                                      "packing_fraction",
                                      "bed_height",
                                      "particles"};
  if (scene.dynamics.overdamped()) {
    columns.insert(columns.end(), {"unbalanced_force", "integrator_steps", "rejected_steps", "force_evaluations"});
  }
  if (!scene.stages.empty()) columns.push_back("stage");
  for (const BoundarySpec& boundary : scene.boundaries) {
    for (const char* axis : axis_names) columns.push_back(fmt::format("{}.force_{}", boundary.name, axis));
    if (boundary.motion.free) columns.push_back(boundary.name + ".travel");
  }
  return columns;
}

std::vector<double> history_row(const Scene& scene, const HistorySources& from) {
  const EnergyAccount& account = from.account;
  const StepSums& sums = from.sums;
  const auto contacts = static_cast<double>(sums.particle_contacts), particles = static_cast<double>(from.particles);
  std::vector<double> row = {static_cast<double>(from.step),
                             from.time,
                             sums.kinetic_translational,
                             sums.kinetic_rotational,
                             sums.elastic,
                             sums.attractive,
                             from.gravitational,
                             account.dissipated(),
                             account.dissipated_normal,
                             account.dissipated_tangential,
                             account.growth_work,
                             account.gravity_work,
                             account.wall_work,
                             account.error(),
                             contacts,
                             static_cast<double>(sums.wall_contacts),
                             2 * contacts / std::max(particles, 1.0),
                             sums.largest_overlap_share,
                             std::sqrt(sums.largest_speed_squared),
                             from.bed.bulk_fraction,
                             from.bed.height,
                             particles};
  if (scene.dynamics.overdamped()) {
    row.insert(row.end(), {sums.unbalanced_force, static_cast<double>(from.work.steps),
                           static_cast<double>(from.work.rejected), static_cast<double>(from.work.forces)});
  }
  if (!scene.stages.empty()) row.push_back(static_cast<double>(from.stage));
  for (std::size_t k = 0; k < scene.boundaries.size(); ++k) {
    const Vec3& force = from.wall_loads[k].force;
    row.insert(row.end(), {force[0], force[1], force[2]});
    if (scene.boundaries[k].motion.free) row.push_back(from.boundaries[k].travel);
  }
  return row;
}

}  // namespace packstone::engine
