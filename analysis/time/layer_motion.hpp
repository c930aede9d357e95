// How layers of the bed move: mean velocity, granular temperature, where the bed rests.
#pragma once

#include <vector>

#include "analysis/context.hpp"
#include "analysis/layers.hpp"
#include "analysis/result.hpp"

namespace packstone::analysis {

/// Sums over the particles whose centres lie in a layer.
struct LayerMotion {
  double mass = 0;               ///< [kg]
  double squared_mass = 0;       ///< sum of m^2 [kg2]
  Vec3 momentum = Vec3::Zero();  ///< [kg m/s]
  double kinetic = 0;            ///< of the translation [J]
  double weight = 0;             ///< sum of m g d [J]
  std::size_t particles = 0;

  /// sum m |v - V|^2 about the layer's own V, over 3 times what makes it free of bias [m2/s2]: sum m - sum m^2/sum m.
  /// NaN with fewer than two particles.
  double temperature() const;
  double fluctuation() const;         ///< sum m |v - V|^2 [J]
  double degrees_of_freedom() const;  ///< sum m - sum m^2 / sum m [kg]
};

/// By layers one mean diameter thick. velocity: (3 N) [m/s].
struct MotionOfLayers {
  Layers layers;
  std::vector<LayerMotion> motion;
};
MotionOfLayers motion_of_layers(const Snapshot& snapshot, const Context& context, const std::vector<double>& velocity);

/// Adds granular_temperature, rest_height and the table of the layers; where there are no velocities, why not.
void add_layer_motion(MeasureResult& result, const Snapshot& snapshot, const Context& context,
                      const std::string& no_velocities);

}  // namespace packstone::analysis
