// What a scene could do without, with numbers: model no more than it needs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/scene.hpp"

namespace packstone::engine {

struct SceneCheck;
class Simulation;

struct Simplification {
  std::string key;   ///< of the scene
  std::string to;    ///< what it could be
  std::string why;   ///< the numbers behind it
  std::string loss;  ///< what goes with it
  std::string gain;
  std::function<void(Scene&)> apply;
};

/// In the order in which they may be applied. check: of the same scene, but for its simplifications.
std::vector<Simplification> simplifications(const Scene& scene, const Simulation& simulation, const SceneCheck& check);

/// With those applied whose keys are not to be kept.
Scene simplified(Scene scene, const std::vector<Simplification>& all, const std::vector<std::string>& kept);

}  // namespace packstone::engine
