// Gravity over time.
#pragma once

#include <vector>

#include "core/scene.hpp"
#include "engine/formula.hpp"

namespace packstone::engine {

class Gravity {
 public:
  /// Throws InputError located in the scene.
  explicit Gravity(const Scene& scene);

  bool acts(double time) const;
  /// Acceleration; 0 while it does not act [m/s2]. Throws RunFailure where a formula gives no number.
  Vec3 at(double time) const;

 private:
  GravitySpec spec_;
  std::vector<Formula> formula_;
};

}  // namespace packstone::engine
