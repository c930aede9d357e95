// Measure "time": how near the packing is to rest at this instant.
#include "analysis/time/rest.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/measures.hpp"
#include "analysis/time/layer_motion.hpp"

namespace packstone::analysis {

namespace {

struct Motion {
  double kinetic = 0;  // [J]
  double weight = 0;   // sum of m g d [J]
  double mean_speed = 0, max_speed = 0;
};

Motion motion_of(const Snapshot& snapshot, const std::vector<double>& velocity) {
  const double g = snapshot.gravity.norm();
  Motion motion;
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const Vec3 v(velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]);
    const double mass = snapshot.mass(i), speed = v.norm();
    motion.kinetic += 0.5 * mass * speed * speed;
    motion.weight += mass * g * 2 * snapshot.radius[i];
    motion.mean_speed += speed / static_cast<double>(snapshot.size());
    motion.max_speed = std::max(motion.max_speed, speed);
  }
  return motion;
}

std::string reason_against_speeds(const Snapshot& snapshot) {
  if (snapshot.size() == 0) return "no particles";
  const auto found = snapshot.fields.find("velocity");
  if (found == snapshot.fields.end()) return "the snapshot holds no velocity";
  if (found->second.components != 3) return "the snapshot's velocity is not a vector";
  const auto& v = found->second.values;
  if (!std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); })) return "a velocity is not a number";
  return "";
}

}  // namespace

MeasureResult measure_time(const Snapshot& snapshot, const Context& context) {
  Quantity ratio{.key = "kinetic_energy_ratio",
                 .label = "kinetic energy over m g d",
                 .definition =
                     "sum of m v^2 / 2 (translation) over sum of m g d, d the particle's own diameter, g the "
                     "scene's gravity"};
  Quantity rest{.key = "at_rest", .label = "at rest (1 yes, 0 no)"};
  rest.definition = fmt::format("1 when kinetic_energy_ratio < {:g}, else 0", rest_threshold);
  Quantity mean{
      .key = "mean_speed", .label = "mean speed", .unit = "m/s", .definition = "mean of |v| over all particles"};
  Quantity largest{
      .key = "max_speed", .label = "largest speed", .unit = "m/s", .definition = "largest |v| of a particle"};
  Quantity contacts{.key = "contacts_per_particle",
                    .label = "contacts a particle",
                    .definition =
                        "pairs of particles in contact over the number of particles (half of the mean "
                        "coordination number)",
                    .note = context.contacts.source()};

  const std::string reason = reason_against_speeds(snapshot);
  if (!reason.empty()) {
    for (Quantity* q : {&ratio, &rest, &mean, &largest}) *q = not_applicable(*q, reason);
  } else {
    const Motion motion = motion_of(snapshot, snapshot.fields.at("velocity").values);
    mean.value = motion.mean_speed;
    largest.value = motion.max_speed;
    if (motion.weight > 0 && snapshot.has_masses()) {
      ratio.value = motion.kinetic / motion.weight;
      rest.value = *ratio.value < rest_threshold ? 1 : 0;
    } else {
      const std::string why = snapshot.gravity.isZero(0)
                                  ? "no gravity to compare with"
                                  : "the particles have no mass: a density or a radius is not known";
      for (Quantity* q : {&ratio, &rest}) *q = not_applicable(*q, why);
    }
  }
  if (snapshot.size() > 0) {
    contacts.value = static_cast<double>(context.contacts.pairs.size()) / static_cast<double>(snapshot.size());
  } else {
    contacts = not_applicable(contacts, "no particles");
  }
  MeasureResult result{.name = "time", .quantities = {ratio, rest, mean, largest, contacts}};
  add_layer_motion(result, snapshot, context,
                   reason.empty() && !snapshot.has_masses() ? "a density is not known, so masses are not" : reason);
  return result;
}

}  // namespace packstone::analysis
