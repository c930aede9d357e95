#include "analysis/context.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr double most_bond_cutoff = 3;
constexpr int most_bond_neighbours = 100;
constexpr int fewest_pore_points = 2;

void check_rows(const Snapshot& s) {
  if (s.radius.size() != s.size() || s.id.size() != s.size() || s.type.size() != s.size()) {
    throw InputError("the snapshot has " + std::to_string(s.size()) + " positions, but " +
                     std::to_string(s.radius.size()) + " radii, " + std::to_string(s.id.size()) + " ids and " +
                     std::to_string(s.type.size()) + " types; all must agree");
  }
  if (s.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError("the snapshot has " + std::to_string(s.size()) + " particles; at most 2^32 - 1 can be measured");
  }
  for (const auto& [name, field] : s.fields) {
    if (field.values.size() == s.size() * static_cast<std::size_t>(field.components)) continue;
    throw InputError("field '" + name + "' has " + std::to_string(field.values.size()) + " values for " +
                     std::to_string(s.size()) + " particles of " + std::to_string(field.components) + " components");
  }
}

void check_particles(const Snapshot& s) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::string particle = "particle " + std::to_string(s.id[i]);
    if (!s.position[i].allFinite()) throw InputError(particle + ": its position is not a number");
    if (!(s.radius[i] >= 0) || !std::isfinite(s.radius[i])) {
      throw InputError(particle + ": its radius is " + std::to_string(s.radius[i]) + " m; it must be 0 or above");
    }
    if (s.type[i] < 0 || static_cast<std::size_t>(s.type[i]) >= s.groups.size()) {
      throw InputError(particle + ": its type is " + std::to_string(s.type[i]) + ", but the snapshot has " +
                       std::to_string(s.groups.size()) + " groups");
    }
  }
}

void check_contacts(const Contacts& c) {
  const std::size_t rows = c.size();
  if (c.second.size() != rows || c.force.size() != rows || c.normal.size() != rows || c.overlap.size() != rows ||
      c.sliding.size() != rows) {
    throw InputError("the columns of the snapshot's contacts differ in length");
  }
  for (std::size_t k = 0; k < rows; ++k) {
    if (c.force[k].allFinite() && c.normal[k].allFinite() && std::isfinite(c.overlap[k])) continue;
    throw InputError("contact " + std::to_string(k) + ": its force, normal or overlap is not a number");
  }
}

void check_structure_options(const Options& options) {
  for (double length : {options.rdf_range, options.rdf_bin}) {
    if (length >= 0 && std::isfinite(length)) continue;
    throw InputError("a radial distribution function over " + std::to_string(length) +
                     " m; range and bin must be above 0 (0: the default)");
  }
  if (!(options.bond_cutoff >= 1 && options.bond_cutoff <= most_bond_cutoff)) {
    throw InputError("bonds as far as " + std::to_string(options.bond_cutoff) +
                     " sums of radii; the cut-off must be from 1 to " + std::to_string(most_bond_cutoff));
  }
  if (options.bond_neighbours < 0 || options.bond_neighbours > most_bond_neighbours) {
    throw InputError("bonds with " + std::to_string(options.bond_neighbours) + " neighbours; there must be 1 to " +
                     std::to_string(most_bond_neighbours) + " (0: by the cut-off)");
  }
  if (options.pore_points < fewest_pore_points) {
    throw InputError("pore sizes from " + std::to_string(options.pore_points) + " points; there must be " +
                     std::to_string(fewest_pore_points) + " or more");
  }
}

void check_options(const Options& options) {
  for (double thickness : {options.profile_layer, options.segregation_layer, options.wall_layer}) {
    if (!(thickness >= 0) || !std::isfinite(thickness)) {
      throw InputError("a layer of " + std::to_string(thickness) +
                       " m; the thickness must be above 0 (0: the default)");
    }
  }
  for (double least : {options.clusters.gap, options.clusters.least_force}) {
    if (!(least >= 0) || !std::isfinite(least)) {
      throw InputError("clusters joined by a gap or a force of " + std::to_string(least) + "; it must be above 0");
    }
  }
  if (!(options.interior_margin >= 0) || !std::isfinite(options.interior_margin)) {
    throw InputError("an interior " + std::to_string(options.interior_margin) +
                     " diameters from the walls; the margin must be 0 or above");
  }
  if (!(options.map_cell >= 0) || !std::isfinite(options.map_cell)) {
    throw InputError("map cells of " + std::to_string(options.map_cell) +
                     " m; the width must be above 0 (0: the default)");
  }
  if (!(options.segregation_cell >= 0) || !std::isfinite(options.segregation_cell)) {
    throw InputError("segregation cells of " + std::to_string(options.segregation_cell) +
                     " m; the edge must be above 0 (0: the default)");
  }
  if (options.segregation_rings < 0 || options.segregation_rings == 1) {
    throw InputError(std::to_string(options.segregation_rings) +
                     " segregation rings; there must be two or more (0: the default)");
  }
}

void check_force_options(const ForceOptions& options) {
  const auto check = [](const char* name, double value, bool good, const char* range) {
    if (!good) throw InputError(std::string(name) + " is " + std::to_string(value) + "; it must be " + range);
  };
  const auto not_negative = [](double value) { return value >= 0 && std::isfinite(value); };
  const double angle = options.chain_angle;
  check("the chains' threshold", options.chain_threshold, not_negative(options.chain_threshold), "0 or above");
  check("the chains' angle", angle, angle > 0 && angle <= 90, "above 0 and at most 90 degrees");
  check("the kernel's width", options.kernel_width, not_negative(options.kernel_width), "above 0 (0: the default)");
  check("the communities' resolution", options.resolution, options.resolution > 0 && std::isfinite(options.resolution),
        "above 0");
  check_structure_options(options);
}

}  // namespace

Context make_context(const Snapshot& snapshot, const Options& options) {
  check_options(options);
  check_force_options(options.forces);
  check_rows(snapshot);
  check_particles(snapshot);
  if (snapshot.contacts) check_contacts(*snapshot.contacts);
  Context context{options, bed_frame(snapshot), contact_network(snapshot)};
  const BedFrame& frame = context.frame;
  if (!frame.periodic) context.bed = measure_bed(frame.height, snapshot.radius, frame.area);
  if (snapshot.size() > 0) {
    const double sum = std::accumulate(snapshot.radius.begin(), snapshot.radius.end(), 0.0);
    context.mean_radius = sum / static_cast<double>(snapshot.size());
  }
  return context;
}

}  // namespace packstone::analysis
