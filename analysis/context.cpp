#include "analysis/context.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.hpp"

namespace packstone::analysis {

namespace {

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
      (c.sliding.size() != rows && !c.sliding.empty())) {
    throw InputError("the columns of the snapshot's contacts differ in length");
  }
  for (std::size_t k = 0; k < rows; ++k) {
    if (c.force[k].allFinite() && c.normal[k].allFinite() && std::isfinite(c.overlap[k])) continue;
    throw InputError("contact " + std::to_string(k) + ": its force, normal or overlap is not a number");
  }
}

}  // namespace

Context make_context(const Snapshot& snapshot, const Options& options) {
  check_options(options);
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
