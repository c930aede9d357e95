#include "analysis/time/layer_motion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/time/rest.hpp"

namespace packstone::analysis {

namespace {

constexpr double components = 3;

bool moves(const LayerMotion& layer) { return layer.kinetic >= rest_threshold * layer.weight; }

Quantity temperature_of(const MotionOfLayers& bed) {
  Quantity q{.key = "granular_temperature",
             .label = "granular temperature",
             .unit = "m2/s2",
             .definition =
                 "sum over layers and particles of m |v - V|^2 / (3 sum over layers (M - sum m^2 / M)), V and M "
                 "mean velocity and mass of the layer that holds the centre, layers one mean diameter thick "
                 "(Goldhirsch, Annu. Rev. Fluid Mech. 35 (2003) 267, without bias in small layers); uncertainty: "
                 "standard error as if velocities were independent and normal"};
  double fluctuation = 0, freedom = 0;
  std::size_t particles = 0, layers = 0;
  for (const LayerMotion& layer : bed.motion) {
    if (layer.particles < 2 || !(layer.degrees_of_freedom() > 0)) continue;
    fluctuation += layer.fluctuation();
    freedom += layer.degrees_of_freedom();
    particles += layer.particles;
    ++layers;
  }
  if (!(freedom > 0)) return not_applicable(q, "no layer holds two particles with mass");
  q.value = fluctuation / (components * freedom);
  q.uncertainty = *q.value * std::sqrt(2 / (components * static_cast<double>(particles - layers)));
  return q;
}

Quantity rest_height_of(const MotionOfLayers& bed, const Context& context, double gravity) {
  Quantity q{
      .key = "rest_height",
      .label = "height up to which the bed rests",
      .unit = "m",
      .definition = fmt::format("lower side of the lowest layer (one mean diameter thick, by centres) whose kinetic "
                                "energy is {:g} of its sum of m g d or more, above the floor; bed_height where "
                                "none is",
                                rest_threshold)};
  if (gravity == 0) return not_applicable(q, "no gravity to compare with");
  if (context.frame.periodic) return not_applicable(q, "the domain is periodic along up: the packing has no floor");
  for (std::size_t k = 0; k < bed.motion.size(); ++k) {
    if (bed.motion[k].weight > 0 && moves(bed.motion[k])) {
      q.value = bed.layers.lower(k);
      return q;
    }
  }
  q.value = context.bed.height;
  return q;
}

Table table_of(const MotionOfLayers& bed) {
  Table table{.key = "layers",
              .caption =
                  "Layers one mean diameter thick, by centres: particles, mean velocity by mass, granular "
                  "temperature (as granular_temperature, within the layer), kinetic energy over m g d",
              .columns = {{"lower", "m"},
                          {"upper", "m"},
                          {"particles", "", ColumnFormat::integer},
                          {"velocity_x", "m/s"},
                          {"velocity_y", "m/s"},
                          {"velocity_z", "m/s"},
                          {"temperature", "m2/s2"},
                          {"kinetic_energy_ratio"}}};
  for (std::size_t k = 0; k < bed.motion.size(); ++k) {
    const LayerMotion& layer = bed.motion[k];
    const bool heavy = layer.mass > 0;
    const Vec3 v = heavy ? Vec3(layer.momentum / layer.mass) : Vec3::Constant(no_value);
    table.rows.push_back({bed.layers.lower(k), bed.layers.upper(k), static_cast<double>(layer.particles), v[0], v[1],
                          v[2], layer.temperature(), layer.weight > 0 ? layer.kinetic / layer.weight : no_value});
  }
  return table;
}

}  // namespace

double LayerMotion::fluctuation() const { return std::max(0.0, 2 * kinetic - momentum.squaredNorm() / mass); }

double LayerMotion::degrees_of_freedom() const { return mass - squared_mass / mass; }

double LayerMotion::temperature() const {
  if (particles < 2 || !(degrees_of_freedom() > 0)) return no_value;
  return fluctuation() / (components * degrees_of_freedom());
}

MotionOfLayers motion_of_layers(const Snapshot& snapshot, const Context& context, const std::vector<double>& velocity) {
  MotionOfLayers bed;
  bed.layers = layers_over_bed(context.frame, snapshot.radius, 2 * context.mean_radius);
  bed.motion.resize(bed.layers.count);
  const double gravity = snapshot.gravity.norm();
  for (std::size_t i = 0; i < snapshot.size() && bed.layers.count > 0; ++i) {
    const std::ptrdiff_t place = bed.layers.at(context.frame.height[i]), last = bed.motion.size() - 1;
    LayerMotion& layer = bed.motion[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, last))];
    const Vec3 v(velocity[3 * i], velocity[3 * i + 1], velocity[3 * i + 2]);
    const double mass = snapshot.mass(i);
    layer.mass += mass;
    layer.squared_mass += mass * mass;
    layer.momentum += mass * v;
    layer.kinetic += 0.5 * mass * v.squaredNorm();
    layer.weight += mass * gravity * 2 * snapshot.radius[i];
    ++layer.particles;
  }
  return bed;
}

void add_layer_motion(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                      const std::string& no_velocities) {
  MotionOfLayers bed;
  if (no_velocities.empty()) bed = motion_of_layers(snapshot, context, snapshot.fields.at("velocity").values);
  for (Quantity q : {temperature_of(bed), rest_height_of(bed, context, snapshot.gravity.norm())}) {
    if (!no_velocities.empty()) q = not_applicable(q, no_velocities);
    result.quantities.push_back(q);
  }
  if (no_velocities.empty()) result.tables.push_back(table_of(bed));
}

}  // namespace packstone::analysis
