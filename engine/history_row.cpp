#include "engine/history_row.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::engine {

const std::vector<std::string>& history_columns() {
  static const std::vector<std::string> columns = {"step",
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
                                                   "bed_height"};
  return columns;
}

std::vector<double> history_row(std::int64_t step, double time, const EnergyAccount& account, const StepSums& sums,
                                double gravitational, const BedState& bed, std::size_t particles) {
  const auto contacts = static_cast<double>(sums.particle_contacts);
  return {static_cast<double>(step),
          time,
          sums.kinetic_translational,
          sums.kinetic_rotational,
          sums.elastic,
          sums.attractive,
          gravitational,
          account.dissipated(),
          account.dissipated_normal,
          account.dissipated_tangential,
          account.growth_work,
          account.gravity_work,
          account.wall_work,
          account.error(),
          contacts,
          static_cast<double>(sums.wall_contacts),
          2 * contacts / static_cast<double>(std::max<std::size_t>(particles, 1)),
          sums.largest_overlap_share,
          std::sqrt(sums.largest_speed_squared),
          bed.bulk_fraction,
          bed.height};
}

}  // namespace packstone::engine
